#pragma once

#include <mrpt_mapconv/path/LiftPath.h>

#include <cstddef>
#include <string>

namespace mrpt_mapconv::planning
{
/** Finds where a lifted path goes through a slab.
 *
 * liftPath() gives each point the nearest height at which the sphere fits in, so one may lie below
 * a slab and the next one above it. The straight line from one to the next is taken as flyable if
 * all of it is within a cell of where the sphere fits in: at one of the two points, at any height.
 */
class ClimbCheck
{
 public:
  /** \param layers, conversion, params, voxels as for liftPath(), for an aerial robot */
  ClimbCheck(const freespace::Layers& layers, const freespace::ConversionParams& conversion,
             const path::LiftParams& params, const voxel::VoxelSource* voxels);

  /** Index of the first point of a feasible path that cannot be reached from the one before; 0 if
   * there is none. */
  std::size_t firstBlocked(const path::LiftedPath& path) const;

 private:
  bool isBlocked(const mrpt::math::TPoint3D& from, const mrpt::math::TPoint3D& to) const;
  /** How far a point is from the nearest height at which the sphere fits in at a place [m]. */
  double distanceToFit(const mrpt::math::TPoint3D& place, const mrpt::math::TPoint3D& at) const;

  const freespace::Layers& m_layers;
  const freespace::ConversionParams& m_conversion;
  path::LiftParams m_params;
  const voxel::VoxelSource* m_voxels;
};

}  // namespace mrpt_mapconv::planning
