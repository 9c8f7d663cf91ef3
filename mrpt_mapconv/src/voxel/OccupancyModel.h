#pragma once

#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>
#include <octomap/octomap_utils.h>

#include "Clamping.h"

namespace mrpt_mapconv::voxel
{
/** OctoMap's sensor model, in log-odds, with its very rounding. */
struct OccupancyModel
{
  explicit OccupancyModel(const TVoxelInsertionOptions& options)
      : hit(octomap::logodds(options.probHit)),
        miss(octomap::logodds(options.probMiss)),
        occupiedFrom(octomap::logodds(options.occupancyThres)),
        range{octomap::logodds(options.clampingThresMin),
              octomap::logodds(options.clampingThresMax)}
  {
  }

  float hit, miss, occupiedFrom;
  ClampingRange range;
};

}  // namespace mrpt_mapconv::voxel
