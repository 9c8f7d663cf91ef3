#include "experiment/freespace/Ways.h"

#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

namespace mapconv
{
using namespace mrpt_mapconv;
using mrpt::math::TPoint3D;

namespace
{
bool isFreeAt(const grid::Layer<float>& layer, const TPoint3D& point)
{
  const grid::GridFrame& frame = layer.frame();
  const auto kx = grid::cellKey(point.x, frame.resolution);
  const auto ky = grid::cellKey(point.y, frame.resolution);
  return frame.containsKey(kx, ky) && grid::isFree(layer.cells()[frame.indexOfKey(kx, ky)]);
}
}  // namespace

Way wayOf(const planning::RobotPath& path)
{
  Way way;
  if (path.found())
    for (const auto& point : path.path.points) way.push_back(point.position);
  return way;
}

planning::RobotPath planGround(const GroundMap& map, const FreespaceWorld& world, const Pair& pair,
                               const voxel::VoxelSource& voxels)
{
  planning::RobotPathQuery query;
  query.start = pair.start;
  query.goal = pair.goal;
  query.robotRadius = world.robotRadius;
  query.lift.robot = freespace::Robot::Ground;
  query.lift.heightOffset = 0;
  return planning::planRobotPath(map.layers, map.params, query, &voxels);
}

bool leavesFree(const Way& way, const grid::Layer<float>& truth)
{
  constexpr double kStep = 0.02;  // [m]
  return anyAlong(way, kStep, [&](const TPoint3D& at) { return !isFreeAt(truth, at); });
}

bool touches(const Way& way, double radius, const sim::World& world)
{
  constexpr double kStep = 0.05, kSpacing = 0.01;  // [m]
  return anyAlong(way, kStep,
                  [&](const TPoint3D& at) { return world.sphereHits(at, radius, kSpacing); });
}

}  // namespace mapconv
