#pragma once

#include <mrpt_mapconv/freespace/OpenColumns.h>
#include <mrpt_mapconv/grid/GridFrame.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>

#include <cstdint>
#include <vector>

#include "ColumnRuns.h"

namespace mrpt_mapconv::freespace
{
/** What has to be done in one block of columns, and what the first two passes find there. What
 * differs from what the layers held is not asked of blank ones. */
struct BlockJob
{
  voxel::BlockKey key;
  voxel::ColumnMask changed{};  //!< columns whose voxels may have changed: to be read
  voxel::ColumnMask reach{};  //!< columns whose layers may depend on those, here or in other blocks

  voxel::ColumnMask newGround{};   //!< of `changed`: floor, evidence or OpenColumn differs
  voxel::ColumnMask newSpan{};     //!< of `changed`: floor or ceiling differs
  voxel::ColumnMask newAerial{};   //!< of `reach`: the aerial occupancy differs
  std::vector<OpenColumn> open;    //!< of `changed`, those in which something is, in their order
  std::vector<OccupiedRun> walls;  //!< occupied runs of columns that are not free but may touch a
                                   //!< free one; column by column
};

/** Where a block lies in a layer's frame: index of its first cell, which may be outside. */
struct BlockPlace
{
  BlockPlace(voxel::BlockKey key, const grid::GridFrame& frame)
      : x(key.x * voxel::kBlockSide - frame.x0), y(key.y * voxel::kBlockSide - frame.y0)
  {
  }
  std::int32_t x, y;
};

}  // namespace mrpt_mapconv::freespace
