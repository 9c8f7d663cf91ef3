#pragma once

#include <mrpt_mapconv/planning/RobotPath.h>

#include <optional>

namespace mrpt_mapconv::planning
{
/** What would have to change so that there is a path: of each parameter, on its own, the value
 * nearest to the present one that was found to do; nothing where none did. */
struct Remedies
{
  /** In whole centimetres, half a cell at least: a map tells nothing of a smaller robot [m]. */
  std::optional<double> robotRadius;
  /** Of an aerial robot, whole cells from the present one, to a millimetre [m]. */
  std::optional<double> heightOffset;
  /** What a ground robot would have to climb, and the map to be converted with: whole voxels,
   * rounded up to a millimetre [m]. */
  std::optional<double> maxStep;
  bool maxStepUnknown = false;  //!< not tried, for want of a voxel map
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
