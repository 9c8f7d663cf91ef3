#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/planning/GridPlanner.h>
#include <mrpt_mapconv/planning/RobotPath.h>

#include <cmath>

namespace mrpt_mapconv::planning
{
namespace
{
double lengthOf(const std::vector<mrpt::math::TPoint2D>& points)
{
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

/** Blocks the cells of the points that no height fits. \return false if there are none */
bool blockMisfits(const path::LiftedPath& path, grid::Layer<float>& occupancy)
{
  const grid::GridFrame& frame = occupancy.frame();
  bool any = false;
  for (const path::LiftedPoint& point : path.points)
  {
    if (point.problem == path::Infeasibility::None) continue;
    const std::int32_t kx = grid::cellKey(point.position.x, frame.resolution);
    const std::int32_t ky = grid::cellKey(point.position.y, frame.resolution);
    if (!frame.containsKey(kx, ky)) continue;
    occupancy.cells()[frame.indexOfKey(kx, ky)] = 1;
    any = true;
  }
  return any;
}
}  // namespace

RobotPath planRobotPath(const freespace::Layers& layers,
                        const freespace::ConversionParams& conversion, const RobotPathQuery& query,
                        const voxel::VoxelSource* voxels)
{
  grid::Layer<float> occupancy =
      query.lift.robot == freespace::Robot::Ground ? layers.ground : layers.aerial;
  RobotPath result;
  std::string misfit;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt)
  {
    const GridPath way = planOnGrid(occupancy, query.start, query.goal, query.robotRadius);
    if (!way.found())
    {
      // what blocked the way is said, not that our own blocks did
      result.problem = misfit.empty() ? way.problem : misfit;
      return result;
    }
    result.length = lengthOf(way.points);
    result.path = path::liftPath(way.points, layers, conversion, query.lift, voxels);
    const auto problem = result.path.firstProblem();
    if (!problem) return result;
    if (misfit.empty())
      misfit = "there is a way in 2D, but not in 3D: " + result.path.describeProblem(*problem);
    if (!blockMisfits(result.path, occupancy)) break;
  }
  result.problem = misfit;
  return result;
}

}  // namespace mrpt_mapconv::planning
