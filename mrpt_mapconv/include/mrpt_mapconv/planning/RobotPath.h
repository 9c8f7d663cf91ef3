#pragma once

#include <mrpt_mapconv/path/LiftPath.h>

#include <string>

namespace mrpt_mapconv::planning
{
constexpr int kMostAttempts = 100;  //!< of planRobotPath(), if nothing else is said

/** Where a robot is to go, and how large it is. */
struct RobotPathQuery
{
  mrpt::math::TPoint2D start, goal;  //!< [m]
  double robotRadius = 0.3;          //!< of the disc for which the 2D way is planned, ≥ 0 [m]
  path::LiftParams lift;             //!< of the path's heights; also says which robot it is
  int mostAttempts = kMostAttempts;  //!< ways to plan before giving up, ≥ 1
};

/** A way in 3D, or why there is none. */
struct RobotPath
{
  path::LiftedPath path;  //!< feasible; without points if there is a problem
  std::string problem;    //!< in words, with the place; empty if there is a path
  bool found() const { return problem.empty(); }
};

/** Plans on the robot's occupancy layer (planOnGrid) and lifts the way to 3D (liftPath).
 *
 * A ground robot is not led over steps of the ground (Layers::support) that are higher than
 * path::StepLimit allows from one cell to the next; where there is no way without one, the problem
 * names it.
 *
 * Occupancy does not tell whether a sphere fits in between the floors and ceilings around a place.
 * Where the lifted way shows that it does not, that is looked at and the way is planned anew: cells
 * at whose centre liftPath() finds no height are left out, those around them too; cells in which
 * only other places are bad are crossed from side to side through their centres. So are cells
 * between whose points path::PieceCheck finds a fault; where it still does, one is left out.
 *
 * So if passable cells (see planOnGrid) in whose centres the robot fits lead side by side from the
 * start's to the goal's, there is a path, and it is found unless mostAttempts ways have been bad
 * before, or something lies between two points, as a slab does if one is below and the next above
 * it: that is led around, too, but not every way around is tried, as heights depend on the way. On
 * the path found PieceCheck finds no fault, the sphere is clear at every point, and between two
 * points never more than a cell away from a place where it is.
 *
 * \param layers, conversion, voxels as for liftPath()
 * \exception std::invalid_argument as planOnGrid() and liftPath(), and for mostAttempts < 1 */
RobotPath planRobotPath(const freespace::Layers& layers,
                        const freespace::ConversionParams& conversion, const RobotPathQuery& query,
                        const voxel::VoxelSource* voxels = nullptr);

}  // namespace mrpt_mapconv::planning
