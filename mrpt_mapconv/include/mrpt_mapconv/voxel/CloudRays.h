#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/observation/CloudTimes.h>
#include <mrpt_mapconv/voxel/RayInsertion.h>

#include <cstddef>

namespace mrpt_mapconv::voxel
{
/** What insertCloud() did. */
struct InsertedCloud
{
  std::size_t points = 0;     //!< that were inserted
  std::size_t withheld = 0;   //!< that the cloud marks as not to be used
  std::size_t uncovered = 0;  //!< at whose time the trajectory has no pose
};

/** Inserts each point of a cloud as a ray from where the sensor was at its time, in the cloud's
 * order, see insertRays(): free along it, occupied at its end.
 * \param cloud with times \param sensor its poses, in the cloud's coordinates [m] before its origin
 * was taken off
 * \exception std::invalid_argument for a cloud without times, or as insertRays()
 * \exception std::runtime_error as insertRays(); rays before the failing million are in the map */
InsertedCloud insertCloud(VoxelGrid& grid, const cloud::PointCloud& cloud,
                          const observation::PoseTrack& sensor,
                          const observation::CloudTimes& times, const RayParams& params,
                          int threads = 0);

}  // namespace mrpt_mapconv::voxel
