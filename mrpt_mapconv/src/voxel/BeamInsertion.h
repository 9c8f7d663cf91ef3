#pragma once

#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>

#include "ScanBeams.h"

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::voxel
{
/** A scan's beams on a map; says so of those that had to be left out. */
ScanBeams beamsOf(double resolution, const observation::SensorPoints& scan,
                  const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings);

/** insertScan() of beams. @{ */
ColumnSet insertBeams(octomap::OcTree& tree, const ScanBeams& beams,
                      const TVoxelInsertionOptions& options);
ColumnSet insertBeams(VoxelGrid& grid, const ScanBeams& beams,
                      const TVoxelInsertionOptions& options, int threads);
/** @} */

}  // namespace mrpt_mapconv::voxel
