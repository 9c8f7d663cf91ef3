#pragma once

#include <mrpt_mapconv/observation/SensorPoints.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>
#include <octomap/OcTree.h>

namespace mrpt_mapconv::oracle
{
/** Inserts a scan into a tree by what OctoMap itself has for it: insertPointCloud(), or
 * computeRayKeys() for every beam and updateNode() for every voxel where the scan has beams without
 * return, or one that OctoMap would have go on at the other end of the tree's range. */
void insertScan(octomap::OcTree& tree, const observation::SensorPoints& scan,
                const voxel::TVoxelInsertionOptions& options);

}  // namespace mrpt_mapconv::oracle
