#include <mrpt_mapconv/eval/LayerErrors.h>
#include <mrpt_mapconv/eval/OccupancyScore.h>

#include <cmath>

#include "experiment/freespace/FreespaceResult.h"
#include "experiment/report/Spread.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** An occupancy map to be judged. */
struct Candidate
{
  std::string robot, method;
  const grid::Layer<float>* map;
  const grid::Layer<float>* truth;
};

std::vector<Candidate> candidatesOf(const FreespaceMaps& maps)
{
  const auto* aerial = &maps.truth.aerial;
  const auto* ground = &maps.truth.ground;
  std::vector<Candidate> candidates = {
      {"aerial", "free-space projection", &maps.layers.aerial, aerial},
      {"aerial", "fixed: slice", &maps.slice, aerial},
      {"aerial", "fixed: whole height", &maps.wholeHeight, aerial},
      {"ground", "free-space projection (Table I)", &maps.layers.ground, ground}};
  for (const GroundMap& map : maps.ground)
    candidates.push_back(
        {"ground", "free-space projection (" + map.name + ")", &map.layers.ground, ground});
  candidates.push_back({"ground", "fixed: slice", &maps.slice, ground});
  candidates.push_back({"ground", "fixed: whole height", &maps.wholeHeight, ground});
  return candidates;
}

/** Share of all truly free cells, seen or not, that the map has as free. */
double freeAreaFound(const Candidate& candidate)
{
  const eval::CellMask everywhere(candidate.truth->frame(), 1);
  return eval::scoreOccupancy(*candidate.map, *candidate.truth, everywhere).free.recall();
}

/** Recall of such bodies' cells that the truth calls occupied, where they were seen. */
double recallOf(const std::vector<std::string>& bodies, const Candidate& candidate,
                const FreespaceResult& result)
{
  const auto cells = eval::cellsOf(result.scenario->world, bodies, candidate.truth->frame());
  return eval::scoreOccupancy(*candidate.map, *candidate.truth,
                              eval::both(cells, result.maps.inView))
      .occupied.recall();
}

void addRows(const FreespaceResult& result, Table& table)
{
  for (const Candidate& candidate : candidatesOf(result.maps))
  {
    const auto score = eval::scoreOccupancy(*candidate.map, *candidate.truth, result.maps.inView);
    const bool ground = candidate.robot == "ground";
    const auto bodies = [&](const auto& names)
    { return ground ? percent(recallOf(names, candidate, result)) : std::string("-"); };
    table.addRow({result.world.name, candidate.robot, candidate.method,
                  percent(score.free.precision()), percent(score.free.recall()),
                  percent(score.occupied.precision()), percent(score.occupied.recall()),
                  bodies(result.world.lowWalls), bodies(result.world.objects),
                  percent(freeAreaFound(candidate))});
  }
}

std::string withinVoxel(const std::vector<double>& errors, double resolution)
{
  std::size_t within = 0;
  for (const double error : errors) within += std::abs(error) <= resolution + 1e-6;
  return percent(static_cast<double>(within) / static_cast<double>(errors.size()));
}

constexpr float kJudgedSlope = 2;  // the paper's steepest slope for a robot

eval::CellMask cellsUpTo(const grid::Layer<float>& layer, float most)
{
  eval::CellMask mask(layer.frame(), 0);
  for (std::size_t i = 0; i < mask.cells().size(); ++i) mask.cells()[i] = layer.cells()[i] <= most;
  return mask;
}

void addErrors(const FreespaceResult& result, Table& table)
{
  // the rim of a sphere has a true slope of any size: no window can follow that
  const auto& maps = result.maps;
  const auto gentle = eval::both(maps.inView, cellsUpTo(maps.truth.slope, kJudgedSlope));
  const auto add = [&](const char* layer, const auto& map, const auto& truth, bool metres)
  {
    const auto& judged = metres ? maps.inView : gentle;
    auto errors = eval::errorsOf(map, truth, judged);
    const auto within = metres ? withinVoxel(errors, result.world.resolution) : std::string("-");
    for (double& error : errors) error = std::abs(error);
    const auto rmse = eval::rmse(map, truth, judged);
    table.addRow({result.world.name, layer, fixed(rmse.value, 3), fixed(spreadOf(errors).median, 3),
                  within, std::to_string(rmse.cells)});
  };
  add("floor [m]", result.maps.layers.floor, result.maps.truth.floor, true);
  add("ceiling [m]", result.maps.layers.ceiling, result.maps.truth.ceiling, true);
  add("slope [m/m]", result.maps.layers.slope, result.maps.truth.slope, false);
}

/** What the worlds' truths ask for. */
std::string truthText(const Results& results)
{
  std::string text;
  for (const FreespaceResult& result : results)
  {
    const sim::TruthParams& truth = result.scenario->truth;
    text += "in " + result.world.name + " an aerial robot needs " + fixed(truth.minClearance, 2) +
            " m of height, a ground robot " + fixed(truth.robotHeight, 2) + " m, slopes up to " +
            fixed(truth.maxSlope, 2) + " and no jump above " + fixed(truth.maxStep, 2) +
            " m within half a cell. ";
  }
  return text;
}
}  // namespace

void addQuality(const Results& results, Report& report)
{
  Table table{"quality",
              "Maps against the true world, in cells with a 3D return",
              {"world", "robot", "method", "free: precision", "free: recall", "occupied: precision",
               "occupied: recall", "low walls found", "objects found", "true free area found"},
              {}};
  Table errors{"heights",
               "Heights and slopes against the true world, in cells with a 3D return",
               {"world", "layer", "RMSE", "median error", "within a voxel", "cells"},
               {}};
  for (const FreespaceResult& result : results)
  {
    addRows(result, table);
    addErrors(result, errors);
  }
  table.note =
      "The truth is evaluated at cell centres from the geometry: " + truthText(results) +
      "Found: cells of such bodies that are occupied in the map. The last column counts all truly "
      "free cells of the world, seen or not.";
  report.addHeading("Quality");
  report.addTable(table);
  errors.note =
      "Slopes are judged where the true one is at most 2. A world without a roof has no true "
      "ceiling.";
  report.addTable(errors);
}

}  // namespace mapconv
