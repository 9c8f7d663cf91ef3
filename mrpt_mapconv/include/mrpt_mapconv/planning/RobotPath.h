#pragma once

#include <mrpt_mapconv/path/LiftPath.h>

#include <string>

namespace mrpt_mapconv::planning
{
/** Where a robot is to go, and how large it is. */
struct RobotPathQuery
{
  mrpt::math::TPoint2D start, goal;  //!< [m]
  double robotRadius = 0.3;          //!< of the disc for which the 2D way is planned, ≥ 0 [m]
  path::LiftParams lift;             //!< of the path's heights; also says which robot it is
};

/** A way in 3D, or why there is none. */
struct RobotPath
{
  path::LiftedPath path;  //!< feasible if there is no problem
  double length = 0;      //!< of the 2D way [m]
  std::string problem;    //!< in words, with the place; empty if there is a path
  bool found() const { return problem.empty(); }
};

/** Plans on the robot's occupancy layer (planOnGrid) and lifts the way to 3D (liftPath).
 *
 * Occupancy does not tell whether a sphere fits in between the floors and ceilings around a place.
 * Where the lifted way shows that it does not, the cells of those points are blocked and the way is
 * planned anew, up to kMostAttempts times.
 *
 * \param layers, conversion, voxels as for liftPath()
 * \exception std::invalid_argument as planOnGrid() and liftPath() */
RobotPath planRobotPath(const freespace::Layers& layers,
                        const freespace::ConversionParams& conversion, const RobotPathQuery& query,
                        const voxel::VoxelSource* voxels = nullptr);

constexpr int kMostAttempts = 100;  //!< of planRobotPath()

}  // namespace mrpt_mapconv::planning
