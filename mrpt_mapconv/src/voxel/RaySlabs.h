#pragma once

#include <mrpt_mapconv/voxel/RayWalk.h>

#include <vector>

namespace mrpt_mapconv::voxel
{
/** Cuts space into up to `count` slabs in which rays have about as many voxels each. Together they
 * hold all voxels. */
std::vector<Slab> slabsFor(const std::vector<GridRay>& rays, int count);

}  // namespace mrpt_mapconv::voxel
