#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

namespace mrpt_mapconv::freespace
{
/** The baseline that OctoMap's server uses: of the voxels of a column that overlap the open
 * interval (zMin, zMax), the cell is occupied (1) if any is occupied, else free (0) if any is free,
 * else unknown (−1).
 *
 * \param zMin,zMax [m], may be infinite
 * \param threads number of threads; 0 = all cores
 * \return occupancy on the xy bounding box of all known voxels
 * \exception std::invalid_argument unless zMin < zMax
 * \exception std::runtime_error for a map without any known voxel */
grid::Layer<float> projectFixed(const voxel::VoxelSource& source, double zMin, double zMax,
                                int threads = 0);

/** Follows a change of the source in the columns `changed`: the same cells as projectFixed() gives,
 * on a frame that grows, see grownFrame(), to hold them.
 * \param layer from projectFixed() or an earlier call, with the same zMin and zMax, or empty
 * \exception std::invalid_argument unless zMin < zMax
 * \exception std::runtime_error for a frame of more than 4·10^8 cells */
void updateFixed(const voxel::VoxelSource& source, const voxel::ColumnSet& changed, double zMin,
                 double zMax, grid::Layer<float>& layer, int threads = 0);

}  // namespace mrpt_mapconv::freespace
