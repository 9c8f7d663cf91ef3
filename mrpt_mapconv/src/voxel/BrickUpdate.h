#pragma once

#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "OccupancyModel.h"

namespace mrpt_mapconv::voxel
{
/** The voxels of a brick that beams go through or end in: for each column a bit for each voxel. */
struct alignas(64) BrickBits
{
  std::array<std::uint16_t, kBrickColumns> crossed{}, hit{};

  bool hasHit() const
  {
    return std::any_of(hit.begin(), hit.end(), [](std::uint16_t column) { return column != 0; });
  }
};

/** What an update did to a brick. */
struct BrickChange
{
  /** Bit x of row y: in that column a voxel became known, or changed between free and occupied. */
  std::array<std::uint16_t, kBrickSide> rows{};
  bool value = false;  //!< some log-odds changed
};

/** Updates voxels: a hit where a beam ends, else a miss where one goes through. As OctoMap, which
 * leaves a known voxel that is at its bound, or beyond, as it is. */
void updateBrick(VoxelGrid::Brick& brick, const BrickBits& bits, const OccupancyModel& model,
                 BrickChange& change);

/** Whether a miss changes a voxel. */
bool changesByMiss(float logOdds, const OccupancyModel& model);

}  // namespace mrpt_mapconv::voxel
