#pragma once

#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>
#include <mrpt_mapconv/voxel/VoxelMap.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::voxel
{
/** Inserts a scan into an octree by OctoMap, or into a grid as if it were one: free along each
 * beam, occupied at its end if something returned from there, each voxel at most once. The log-odds
 * are, bit for bit, those of octomap::OcTree::insertPointCloud() with beams without return as
 * clearing ones; but a beam ends where rounding errors take it out of the range of ±32768 voxels,
 * while OctoMap's go on at the other end of it. A map with both engines: VoxelMap.
 *
 * \param scan its points and the pose of the sensor in the map
 * \param warnings told of points that lie outside the range of ±32768 voxels (left out)
 * \param threads 0 = all cores
 * \return the columns in which a voxel has become known or has changed between free and occupied
 * \exception std::runtime_error for a sensor pose that is not finite or outside the range, or for a
 * grid that would exceed options.maxMemory; the map then stays as it was @{ */
ColumnSet insertScan(octomap::OcTree& tree, const observation::SensorPoints& scan,
                     const TVoxelInsertionOptions& options,
                     observation::SayOnceLog* warnings = nullptr);
ColumnSet insertScan(VoxelGrid& grid, const observation::SensorPoints& scan,
                     const TVoxelInsertionOptions& options,
                     observation::SayOnceLog* warnings = nullptr, int threads = 0);
/** @} */

/** What a series of scans did to a voxel map. */
struct InsertedScans
{
  ColumnSet changed;                  //!< as insertScan() gives them, of all scans
  std::size_t scans = 0, points = 0;  //!< that were inserted
};

/** Inserts scans into a voxel map one after another, each as insertScan() does. Passed over are
 * observations of other classes, scans without beams and, unless `options.insert2D`, 2D scans.
 *
 * \param warnings told of what could not be used; may be null
 * \param progress told, before each scan, the share of them that is done, [0, 1); may be empty
 * \param threads 0 = all cores; an octree takes one
 * \exception std::runtime_error for a scan whose data are damaged or whose sensor pose is not
 * valid; the scans before it are in the map by then @{ */
InsertedScans insertScans(octomap::OcTree& tree,
                          const std::vector<observation::PosedObservation>& scans,
                          const TVoxelInsertionOptions& options,
                          observation::SayOnceLog* warnings = nullptr,
                          const std::function<void(double)>& progress = {});
InsertedScans insertScans(VoxelMap& map, const std::vector<observation::PosedObservation>& scans,
                          const TVoxelInsertionOptions& options,
                          observation::SayOnceLog* warnings = nullptr,
                          const std::function<void(double)>& progress = {}, int threads = 0);
/** @} */

}  // namespace mrpt_mapconv::voxel
