#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/planning/GridPlanner.h>
#include <mrpt_mapconv/planning/RobotPath.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "experiment/freespace/FreespaceResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using freespace::Robot;
using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;

namespace
{
constexpr std::uint64_t kSeed = 7;
constexpr double kLeastDistance = 5;  // between start and goal [m]

struct Pair
{
  TPoint2D start, goal;
};

/** Start–goal pairs in seen cells between which there is a way in the true map. */
class PairSource
{
 public:
  PairSource(const grid::Layer<float>& truth, const eval::CellMask& seen, double robotRadius)
      : m_truth(truth), m_robotRadius(robotRadius)
  {
    const auto mask = eval::both(eval::CellMask(truth.frame(), 1), seen);
    for (std::size_t i = 0; i < mask.cells().size(); ++i)
      if (mask.cells()[i] && grid::isFree(truth.cells()[i])) m_cells.push_back(i);
  }

  std::vector<Pair> take(int count)
  {
    constexpr int kTriesPerPair = 50;
    std::vector<Pair> pairs;
    for (int i = 0; i < count * kTriesPerPair && !m_cells.empty(); ++i)
    {
      if (static_cast<int>(pairs.size()) == count) break;
      const Pair pair{somewhere(), somewhere()};
      if ((pair.goal - pair.start).norm() < kLeastDistance) continue;
      if (planning::planOnGrid(m_truth, pair.start, pair.goal, m_robotRadius).found())
        pairs.push_back(pair);
    }
    return pairs;
  }

 private:
  TPoint2D somewhere()
  {
    const grid::GridFrame& frame = m_truth.frame();
    const std::size_t cell = m_cells[m_random() % m_cells.size()];
    const auto width = static_cast<std::size_t>(frame.width);
    return {(frame.x0 + static_cast<double>(cell % width) + 0.5) * frame.resolution,
            (frame.y0 + static_cast<double>(cell / width) + 0.5) * frame.resolution};
  }

  const grid::Layer<float>& m_truth;
  double m_robotRadius;
  std::vector<std::size_t> m_cells;
  std::mt19937_64 m_random{kSeed};
};

/** What became of the pairs with one method. */
struct PathCounts
{
  int found = 0, touchWorld = 0, leaveFree = 0;
};

/** A method's way between two places; empty if it finds none. */
using Way = std::vector<TPoint3D>;

/** Whether something holds anywhere along a way, looked at in steps of at most `step` [m]. */
template <class Predicate>
bool anyAlong(const Way& way, double step, const Predicate& holds)
{
  if (!way.empty() && holds(way.front())) return true;
  for (std::size_t i = 1; i < way.size(); ++i)
  {
    const TPoint3D along = way[i] - way[i - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(along.norm() / step)));
    for (int k = 1; k <= pieces; ++k)
      if (holds(way[i - 1] + along * (static_cast<double>(k) / pieces))) return true;
  }
  return false;
}

class PathJudge
{
 public:
  PathJudge(const FreespaceResult& result, const grid::Layer<float>& truth)
      : m_result(result), m_truth(truth)
  {
  }

  void count(const Way& way, bool flies, PathCounts& counts) const
  {
    if (way.empty()) return;
    ++counts.found;
    // every method's segments alike, however far apart its points are
    constexpr double kSphereStep = 0.05, kPointStep = 0.02;  // [m]
    counts.touchWorld +=
        flies && anyAlong(way, kSphereStep, [&](const auto& at) { return touches(at); });
    counts.leaveFree += anyAlong(way, kPointStep, [&](const auto& at) { return !isTrulyFree(at); });
  }

 private:
  bool touches(const TPoint3D& point) const
  {
    constexpr double kSpacing = 0.01;  // of the lines by which the sphere is tried [m]
    return m_result.scenario->world.sphereHits(point, m_result.world.robotRadius, kSpacing);
  }
  bool isTrulyFree(const TPoint3D& point) const
  {
    const grid::GridFrame& frame = m_truth.frame();
    const auto kx = grid::cellKey(point.x, frame.resolution);
    const auto ky = grid::cellKey(point.y, frame.resolution);
    return frame.containsKey(kx, ky) && grid::isFree(m_truth.cells()[frame.indexOfKey(kx, ky)]);
  }

  const FreespaceResult& m_result;
  const grid::Layer<float>& m_truth;
};

/** The path of the free-space projection's map, lifted. */
Way liftedWay(const FreespaceResult& result, const FreespaceSettings& settings, Robot robot,
              const Pair& pair, const voxel::VoxelSource& voxels)
{
  const bool ground = robot == Robot::Ground;
  planning::RobotPathQuery query;
  query.start = pair.start;
  query.goal = pair.goal;
  query.robotRadius = ground ? result.world.robotRadius : result.world.safetyRadius;
  query.lift.robot = robot;
  query.lift.safetyRadius = result.world.safetyRadius;
  query.lift.heightOffset = ground ? 0 : settings.conversion.minClearance / 2;
  const auto path = planning::planRobotPath(
      ground ? result.maps.strict : result.maps.layers,
      ground ? settings.strictConversion : settings.conversion, query, &voxels);
  Way way;
  if (path.found())
    for (const auto& point : path.path.points) way.push_back(point.position);
  return way;
}

/** The path on a fixed projection, flown at a height. */
Way flatWay(const grid::Layer<float>& map, const Pair& pair, double robotRadius, double height)
{
  const auto path = planning::planOnGrid(map, pair.start, pair.goal, robotRadius);
  Way way;
  for (const TPoint2D& point : path.points) way.emplace_back(point.x, point.y, height);
  return way;
}

void addRows(const FreespaceResult& result, const FreespaceSettings& settings, Robot robot,
             Progress& progress, Table& table)
{
  const bool ground = robot == Robot::Ground;
  const auto& truth = ground ? result.maps.truth.ground : result.maps.truth.aerial;
  const double radius = ground ? result.world.robotRadius : result.world.safetyRadius;
  const std::string name = ground ? "ground" : "aerial";
  progress.stage("paths of the " + name + " robot in " + result.world.name);
  const auto pairs = PairSource(truth, result.maps.seen, radius).take(settings.pairs);
  const voxel::OctreeSource<octomap::OcTree> voxels(*result.run.tree);
  const PathJudge judge(result, truth);
  const double height =
      result.run.startHeight + (result.world.sliceAbove - result.world.sliceBelow) / 2;
  PathCounts ours, slice, whole;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    progress.done(static_cast<double>(i) / static_cast<double>(pairs.size()));
    judge.count(liftedWay(result, settings, robot, pairs[i], voxels), !ground, ours);
    judge.count(flatWay(result.maps.slice, pairs[i], radius, height), !ground, slice);
    judge.count(flatWay(result.maps.wholeHeight, pairs[i], radius, height), !ground, whole);
  }
  const auto add = [&](const std::string& method, const PathCounts& counts)
  {
    table.addRow({result.world.name, name, method, std::to_string(pairs.size()),
                  std::to_string(counts.found), ground ? "-" : std::to_string(counts.touchWorld),
                  std::to_string(counts.leaveFree)});
  };
  add("free-space projection and lifting", ours);
  const std::string flown = ground ? "" : " (flown at the slice's middle)";
  add("fixed: slice" + flown, slice);
  add("fixed: whole height" + flown, whole);
}
}  // namespace

void addPaths(const std::vector<FreespaceResult>& results, const FreespaceSettings& settings,
              Progress& progress, Report& report)
{
  Table table{"paths",
              "Random start–goal pairs, between which there is a way in the true map",
              {"world", "robot", "method", "pairs", "paths found",
               "of these touch the true world (sphere)", "of these leave truly free cells"},
              {}};
  for (const auto& result : results)
    for (const Robot robot : {Robot::Aerial, Robot::Ground})
      addRows(result, settings, robot, progress, table);
  table.note =
      "Aerial paths are planned and lifted with safetyRadius; what must not touch the world is the "
      "robot's own sphere, tried every 5 cm of the way by vertical lines every 1 cm; whether a way "
      "leaves truly free cells is looked at every 2 cm.";
  report.addHeading("Paths");
  report.addTable(table);
}

}  // namespace mapconv
