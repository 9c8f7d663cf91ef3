#pragma once

#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <mrpt_mapconv/voxel/RayWalk.h>

#include <vector>

namespace mrpt_mapconv::voxel
{
/** Rays in a grid's units, in order, and what is known of them beforehand. */
struct SnappedRays
{
  std::vector<GridRay> rays;
  std::vector<RayEnd> ends;
  InsertedRays counts;
};

/** Snaps the ends of rays to 1/256 voxel and cuts rays at maxRange [m] (-1: nowhere); rays that are
 * not finite are left out and counted.
 * \exception std::out_of_range for a ray that leaves the range of +-2^31 voxels */
SnappedRays snapRays(const std::vector<Ray>& rays, double resolution, double maxRange);

}  // namespace mrpt_mapconv::voxel
