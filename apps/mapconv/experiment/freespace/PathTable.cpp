#include <mrpt_mapconv/planning/GridPlanner.h>
#include <mrpt_mapconv/planning/RobotPath.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>

#include <string>
#include <utility>

#include "experiment/freespace/FreespaceResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using mrpt::math::TPoint2D;

namespace
{
/** What became of the pairs with one method. */
struct PathCounts
{
  std::size_t found = 0, touchWorld = 0, leaveFree = 0;
};

/** Aerial robots' ways are also looked at whether they touch the world. */
class PathCounter
{
 public:
  PathCounter(const FreespaceResult& result, const grid::Layer<float>& truth, bool flies)
      : m_result(result), m_truth(truth), m_flies(flies)
  {
  }

  void add(const Way& way)
  {
    if (way.empty()) return;
    ++counts.found;
    counts.leaveFree += leavesFree(way, m_truth);
    counts.touchWorld +=
        m_flies && touches(way, m_result.world.robotRadius, m_result.scenario->world);
  }

  PathCounts counts;

 private:
  const FreespaceResult& m_result;
  const grid::Layer<float>& m_truth;
  bool m_flies;
};

/** The path of the free-space projection's map, lifted. */
Way liftedWay(const FreespaceResult& result, const FreespaceSettings& settings, const Pair& pair,
              const voxel::VoxelSource& voxels)
{
  planning::RobotPathQuery query;
  query.start = pair.start;
  query.goal = pair.goal;
  query.robotRadius = query.lift.safetyRadius = result.world.safetyRadius;
  query.lift.heightOffset = settings.conversion.minClearance / 2;
  return wayOf(planning::planRobotPath(result.maps.layers, settings.conversion, query, &voxels));
}

/** The path on a fixed projection, flown at a height. */
Way flatWay(const grid::Layer<float>& map, const Pair& pair, double robotRadius, double height)
{
  const auto path = planning::planOnGrid(map, pair.start, pair.goal, robotRadius);
  Way way;
  for (const TPoint2D& point : path.points) way.emplace_back(point.x, point.y, height);
  return way;
}

/** Rows for one robot in one world. */
class PathRows
{
 public:
  PathRows(const FreespaceResult& result, std::string robot, std::size_t pairs, Table& table)
      : m_world(result.world.name), m_robot(std::move(robot)), m_pairs(pairs), m_table(table)
  {
  }
  void add(const std::string& method, const PathCounts& counts, bool flies) const
  {
    m_table.addRow({m_world, m_robot, method, std::to_string(m_pairs), std::to_string(counts.found),
                    flies ? std::to_string(counts.touchWorld) : "-",
                    std::to_string(counts.leaveFree)});
  }

 private:
  std::string m_world, m_robot;
  std::size_t m_pairs;
  Table& m_table;
};

/** The fixed projections' rows. */
void addFixed(const FreespaceResult& result, const std::vector<Pair>& pairs,
              const grid::Layer<float>& truth, bool flies, const PathRows& rows)
{
  const FreespaceWorld& world = result.world;
  const double radius = flies ? world.safetyRadius : world.robotRadius;
  const double height = result.run.startHeight + (world.sliceAbove - world.sliceBelow) / 2;
  const std::string flown = flies ? " (flown at the slice's middle)" : "";
  for (const auto& [name, map] : {std::pair{"fixed: slice", &result.maps.slice},
                                  {"fixed: whole height", &result.maps.wholeHeight}})
  {
    PathCounter counter(result, truth, flies);
    for (const Pair& pair : pairs) counter.add(flatWay(*map, pair, radius, height));
    rows.add(name + flown, counter.counts, flies);
  }
}

void addAerial(const FreespaceResult& result, const FreespaceSettings& settings, Progress& progress,
               Table& table)
{
  const auto& truth = result.maps.truth.aerial;
  const auto pairs =
      randomPairs(truth, result.maps.inView, result.world.safetyRadius, settings.pairs);
  const voxel::OctreeSource<octomap::OcTree> voxels(*result.run.tree);
  PathCounter ours(result, truth, true);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    progress.done(static_cast<double>(i) / static_cast<double>(pairs.size()));
    ours.add(liftedWay(result, settings, pairs[i], voxels));
  }
  const PathRows rows(result, "aerial", pairs.size(), table);
  rows.add("free-space projection and lifting", ours.counts, true);
  addFixed(result, pairs, truth, true, rows);
}

void addGroundRows(const FreespaceResult& result, Table& table)
{
  const GroundRuns& runs = result.groundRuns;
  const PathRows rows(result, "ground", runs.pairs.size(), table);
  for (std::size_t i = 0; i < kGroundMaps; ++i)
  {
    const GroundPaths& paths = runs.onMap[i];
    rows.add("free-space projection and lifting (" + result.maps.ground[i].name + ")",
             {paths.ways.size(), 0, paths.leaveFree}, false);
  }
  addFixed(result, runs.pairs, result.maps.truth.ground, false, rows);
}
}  // namespace

void addPaths(const Results& results, const FreespaceSettings& settings, Progress& progress,
              Report& report)
{
  Table table{"paths",
              "Random start–goal pairs, between which there is a way in the true map",
              {"world", "robot", "method", "pairs", "paths found",
               "of these touch the true world (sphere)", "of these leave truly free cells"},
              {}};
  for (const FreespaceResult& result : results)
  {
    progress.stage("paths of the aerial robot in " + result.world.name);
    addAerial(result, settings, progress, table);
    addGroundRows(result, table);
  }
  table.note =
      "Aerial paths are planned and lifted with safetyRadius; what must not touch the world is the "
      "robot's own sphere, tried every 5 cm of the way by vertical lines every 1 cm; whether a way "
      "leaves truly free cells is looked at every 2 cm.";
  report.addHeading("Paths");
  report.addTable(table);
}

}  // namespace mapconv
