#include "experiment/freespace/GroundPaths.h"

#include <mrpt_mapconv/voxel/OctreeSource.h>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** Where the middle of the robot's body is when the robot goes along a way. */
Way bodyAlong(const Way& way, const sim::World& world, double aboveGround)
{
  Way body;
  std::vector<sim::Solid> solids;
  for (const auto& point : way)
  {
    world.solidsAt(point.x, point.y, solids);
    if (!solids.empty()) body.emplace_back(point.x, point.y, solids.front().top + aboveGround);
  }
  return body;
}

/** Plans pairs on one map and looks at what comes of it. */
class GroundPlanner
{
 public:
  GroundPlanner(const FreespaceWorld& world, const sim::World& bodies,
                const voxel::VoxelSource& voxels, const grid::Layer<float>& truth)
      : m_world(world), m_bodies(bodies), m_voxels(voxels), m_truth(truth)
  {
  }

  void plan(const GroundMap& map, const Pair& pair, GroundPaths& paths) const
  {
    const Way way = wayOf(planGround(map, m_world, pair, m_voxels));
    if (way.empty())
    {
      ++paths.notFound[eval::whyNoPath(map.layers.ground, m_truth, pair.start, pair.goal,
                                       m_world.robotRadius)];
      return;
    }
    const double step = map.params.maxStepVoxels(m_world.resolution) * m_world.resolution;
    paths.leaveFree += leavesFree(way, m_truth);
    paths.touchWorld += touches(bodyAlong(way, m_bodies, step + m_world.robotRadius),
                                m_world.robotRadius, m_bodies);
    paths.ways.push_back(way);
  }

 private:
  const FreespaceWorld& m_world;
  const sim::World& m_bodies;
  const voxel::VoxelSource& m_voxels;
  const grid::Layer<float>& m_truth;
};
}  // namespace

std::size_t GroundPaths::standable() const
{
  std::size_t pairs = ways.size();
  for (const auto& [reason, times] : notFound)
    if (reason != eval::NoPath::EndUnknown && reason != eval::NoPath::EndOccupied) pairs += times;
  return pairs;
}

double GroundPaths::shareFound() const
{
  return static_cast<double>(ways.size()) / static_cast<double>(standable());
}

GroundRuns planGroundPairs(const FreespaceWorld& world, const sim::World& bodies,
                           const octomap::OcTree& tree, const FreespaceMaps& maps, int pairs,
                           Progress& progress)
{
  const voxel::OctreeSource<octomap::OcTree> voxels(tree);
  const GroundPlanner planner(world, bodies, voxels, maps.truth.ground);
  GroundRuns runs;
  runs.pairs = randomPairs(maps.truth.ground, maps.inView, world.robotRadius, pairs);
  for (std::size_t i = 0; i < runs.pairs.size(); ++i)
  {
    progress.done(static_cast<double>(i) / static_cast<double>(runs.pairs.size()));
    for (std::size_t map = 0; map < kGroundMaps; ++map)
      planner.plan(maps.ground[map], runs.pairs[i], runs.onMap[map]);
  }
  return runs;
}

}  // namespace mapconv
