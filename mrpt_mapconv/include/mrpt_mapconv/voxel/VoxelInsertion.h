#pragma once

#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::voxel
{
/** The frame that holds everything a scan can change: its sensor and the ends of its beams, as far
 * as they lie in the tree. */
grid::GridFrame frameOfScan(const octomap::OcTree& tree, const observation::SensorPoints& scan,
                            const TVoxelInsertionOptions& options);

/** Inserts a scan into a voxel map: free along each beam, occupied at its end.
 *
 * \param scan its points and the pose of the sensor in the map
 * \param warnings told of points that lie outside the tree's range of ±32768 voxels (left out)
 * \return the columns in which a voxel has become known or has changed between free and occupied
 * \exception std::runtime_error for a sensor pose that is not finite or outside the tree's range;
 * the tree then stays as it was */
voxel::ColumnSet insertScan(octomap::OcTree& tree, const observation::SensorPoints& scan,
                            const TVoxelInsertionOptions& options,
                            observation::SayOnceLog* warnings = nullptr);

}  // namespace mrpt_mapconv::voxel
