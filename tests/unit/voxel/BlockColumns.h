#pragma once

#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/ColumnBlock.h>

#include "../../oracle/DenseMap.h"

namespace mrpt_mapconv::test
{
inline voxel::ColumnMask everyColumn()
{
  voxel::ColumnMask mask;
  mask.fill(voxel::kFullRow);
  return mask;
}

/** State of voxel (x, y) of the block at z key kz, straight from the documented bit planes. */
inline oracle::Voxel stateIn(const voxel::ColumnBlock& block, int x, int y, int kz)
{
  using oracle::Voxel;
  const int above = kz - block.zMin();
  if (above < 0 || above >= 64 * block.words()) return Voxel::Unknown;
  const int word = above / 64 * voxel::kBlockColumns + y * voxel::kBlockSide + x;
  const bool free = block.freePlane()[word] >> (above % 64) & 1u;
  const bool occupied = block.occupiedPlane()[word] >> (above % 64) & 1u;
  EXPECT_FALSE(free && occupied) << "voxel (" << x << ", " << y << ", " << kz << ") is both";
  return free ? Voxel::Free : occupied ? Voxel::Occupied : Voxel::Unknown;
}

}  // namespace mrpt_mapconv::test
