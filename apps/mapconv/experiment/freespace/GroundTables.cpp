#include <cmath>

#include "experiment/freespace/GroundFigures.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
std::string number(std::size_t count) { return std::to_string(count); }

using FiguresOfMaps = std::array<GroundFigures, kGroundMaps>;

FiguresOfMaps figuresOf(const FreespaceResult& result)
{
  FiguresOfMaps figures;
  for (std::size_t i = 0; i < kGroundMaps; ++i)
    figures[i] = groundFigures(result, result.maps.ground[i]);
  return figures;
}

void addCells(const FreespaceResult& result, const FiguresOfMaps& all, Table& table)
{
  for (std::size_t i = 0; i < kGroundMaps; ++i)
  {
    const GroundFigures& figures = all[i];
    const auto& score = figures.score;
    table.addRow({result.world.name, result.maps.ground[i].name, percent(score.free.precision()),
                  percent(score.free.recall()), percent(score.occupied.precision()),
                  percent(score.occupied.recall()), number(score.occupied.wrong),
                  number(figures.falseAwayFromAll),
                  number(figures.occupiedLabelledFree) + " of " + number(figures.trulyOccupied()),
                  number(figures.frontier), number(figures.frontierTrulyFree),
                  percent(figures.lowWalls), percent(figures.objects)});
  }
}

/** "4 an end unknown, 1 blocked by unknown". */
std::string reasons(const GroundPaths& paths)
{
  std::string text;
  for (const auto& [reason, times] : paths.notFound)
    text += (text.empty() ? "" : ", ") + number(times) + " " +
            eval::namesOf(reason).at(static_cast<std::size_t>(reason));
  return text.empty() ? "-" : text;
}

void addPairs(const FreespaceResult& result, Table& table)
{
  for (std::size_t i = 0; i < kGroundMaps; ++i)
  {
    const GroundPaths& paths = result.groundRuns.onMap[i];
    table.addRow({result.world.name, result.maps.ground[i].name,
                  number(result.groundRuns.pairs.size()), number(paths.ways.size()),
                  number(paths.standable()), percent(paths.shareFound()), number(paths.leaveFree),
                  number(paths.touchWorld), reasons(paths)});
  }
}

/** What `seen` has to be like, compared with `strict`, in one world. */
class Targets
{
 public:
  Targets(const FreespaceResult& result, const FiguresOfMaps& figures, Table& table)
      : m_world(result.world.name),
        m_strict(figures[0]),
        m_seen(figures[1]),
        m_strictPaths(result.groundRuns.onMap[0]),
        m_seenPaths(result.groundRuns.onMap[1]),
        m_table(table)
  {
  }

  void add() const
  {
    addFalseObstacles();
    addShare("free: precision", m_strict.score.free.precision(), m_seen.score.free.precision(),
             0.002, "at most 0.2 points lower");
    addShare("free: recall", m_strict.score.free.recall(), m_seen.score.free.recall(), 0.002,
             "at most 0.2 points lower");
    addOccupiedLabelledFree();
    if (!std::isnan(m_seen.lowWalls))
      addRow("low walls found within one cell", percent(m_strict.lowWalls),
             percent(m_seen.lowWalls), "100 %", m_seen.lowWalls >= 1);
    if (!std::isnan(m_seen.objects))
      addShare("objects found within one cell", m_strict.objects, m_seen.objects, 0.06,
               "at most 6 points fewer");
    addPaths();
  }

 private:
  void addRow(const std::string& what, const std::string& strict, const std::string& seen,
              const std::string& target, bool met) const
  {
    m_table.addRow({m_world, what, strict, seen, judged(target, met)});
  }
  void addShare(const std::string& what, double strict, double seen, double lower,
                const std::string& target) const
  {
    addRow(what, percent(strict), percent(seen), target, seen >= strict - lower);
  }
  void addFalseObstacles() const
  {
    addRow("false obstacles away from everything", number(m_strict.falseAwayFromAll),
           number(m_seen.falseAwayFromAll), "at most a third",
           3 * m_seen.falseAwayFromAll <= m_strict.falseAwayFromAll);
  }
  void addOccupiedLabelledFree() const
  {
    const auto occupied = static_cast<double>(m_seen.trulyOccupied());
    const double strict = static_cast<double>(m_strict.occupiedLabelledFree) / occupied;
    const double seen = static_cast<double>(m_seen.occupiedLabelledFree) / occupied;
    addRow("truly occupied cells labelled free", percent(strict), percent(seen),
           "at most one point more", !(seen > strict + 0.01));
  }
  void addPaths() const
  {
    if (m_seenPaths.standable() > 0)
      addRow("pairs found of those whose ends are free on the map",
             percent(m_strictPaths.shareFound()), percent(m_seenPaths.shareFound()), "98 %",
             m_seenPaths.shareFound() >= 0.98);
    const auto collisions = [](const GroundPaths& paths)
    { return std::max(paths.leaveFree, paths.touchWorld); };
    addRow("paths that leave truly free cells or touch the world",
           number(collisions(m_strictPaths)), number(collisions(m_seenPaths)), "none",
           collisions(m_seenPaths) == 0);
  }

  std::string m_world;
  const GroundFigures &m_strict, &m_seen;
  const GroundPaths &m_strictPaths, &m_seenPaths;
  Table& m_table;
};
}  // namespace

void addGround(const Results& results, Report& report)
{
  Table cells{"ground_cells",
              "Ground maps against the true world, in cells with a 3D return",
              {"world", "map", "free: precision", "free: recall", "occupied: precision",
               "occupied: recall", "false obstacles", "of these away from everything",
               "truly occupied labelled free", "frontier cells", "of these truly free",
               "low walls within one cell", "objects within one cell"},
              {}};
  Table pairs{"ground_pairs",
              "Random start–goal pairs of a ground robot, between which there is a way in the true "
              "map",
              {"world", "map", "pairs", "paths found", "pairs whose ends are free on the map",
               "of these found", "paths that leave truly free cells",
               "paths that touch the true world", "not found"},
              {}};
  Table targets{"ground_targets",
                "What floors that were seen must be like, compared with the lowest free ones",
                {"world", "figure", "strict", "seen", "target"},
                {}};
  for (const FreespaceResult& result : results)
  {
    const FiguresOfMaps figures = figuresOf(result);
    addCells(result, figures, cells);
    addPairs(result, pairs);
    if (result.world.isJudged) Targets(result, figures, targets).add();
  }
  cells.note =
      "Strict: floorFrom = lowestFree, the parameters of section [strictConversion]; seen: the "
      "same with floorFrom = seen. False obstacles: truly free cells labelled occupied; away from "
      "everything: farther than slopeWindow cells from whatever is not truly free. Frontier cells "
      "are those of the whole map, in view or not. Low walls and objects: their truly occupied "
      "cells in view that have an occupied cell within one cell.";
  pairs.note =
      "Why a pair is not found is what planning on the ground map finds out when truly free cells "
      "that are unknown, or occupied, are made free. Touching is tried with the robot's sphere, "
      "which rolls a step (maxStep, at least a voxel) above the true ground.";
  report.addHeading("Ground that was seen");
  report.addTable(cells);
  report.addTable(pairs);
  report.addTable(targets);
}

}  // namespace mapconv
