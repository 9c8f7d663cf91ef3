#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

namespace mrpt_mapconv::voxel
{
/** The centres of a map's occupied voxels, as points without attributes. */
cloud::PointCloud occupiedCentres(const VoxelSource& source);

}  // namespace mrpt_mapconv::voxel
