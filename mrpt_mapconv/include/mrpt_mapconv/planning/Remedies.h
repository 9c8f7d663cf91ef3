#pragma once

#include <mrpt_mapconv/planning/RobotPath.h>

#include <optional>

namespace mrpt_mapconv::planning
{
/** What would have to change so that there is a path: of each parameter, on its own, the value
 * nearest to the present one that was found to do; nothing where none did. */
struct Remedies
{
  std::optional<double> robotRadius;   //!< in whole centimetres [m]
  std::optional<double> heightOffset;  //!< of an aerial robot, whole cells from the present one [m]
  std::optional<double> maxStep;       //!< to convert with for a ground robot, whole voxels [m]
};

/** Tries, with few attempts each, smaller radii, other height offsets, and higher steps up to
 * minClearance (only with a voxel map, as that is converted anew).
 *
 * A safety radius that equals the robot's radius shrinks with it.
 * \param layers, conversion, query, voxels as for planRobotPath(), which has found no path */
Remedies findRemedies(const freespace::Layers& layers,
                      const freespace::ConversionParams& conversion, const RobotPathQuery& query,
                      const voxel::VoxelSource* voxels = nullptr);

}  // namespace mrpt_mapconv::planning
