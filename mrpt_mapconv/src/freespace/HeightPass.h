#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include "BlockJob.h"
#include "ColumnMasks.h"
#include "ColumnRuns.h"

namespace mrpt_mapconv::freespace
{
/** First pass over a block: the changed columns' voxels → floor, ceiling, walls, evidence, and the
 * support of seen cells. */
class HeightPass
{
 public:
  /** \param open what is in the open columns that the layers hold
   * \param blank whether the layers hold nothing yet: all unknown */
  HeightPass(const voxel::VoxelSource& source, const ConversionParams& params,
             const OpenColumns& open, Layers& layers, bool blank);
  void run(BlockJob& job);

 private:
  /** What is found in one row of the block. Evidence is raw: what is inferred comes later. */
  struct Row
  {
    RowValues floor{}, ceiling{}, support{}, evidence{};
    std::uint32_t free = 0;  //!< columns with a kept free range
  };

  void findRow(std::int32_t y, std::uint32_t columns);
  OpenColumn openColumn(std::int32_t column, std::int32_t floor) const;
  std::uint32_t findOpen(std::int32_t y, BlockJob& job) const;
  voxel::ColumnMask writeHeights(BlockJob& job);
  void collectWalls(BlockJob& job, const voxel::ColumnMask& free);

  const voxel::VoxelSource& m_source;
  const OpenColumns& m_open;
  Layers& m_layers;
  bool m_blank, m_supportIsFloor;
  std::int32_t m_reachAbove;  //!< how far over a floor things may be in the way [voxels]
  voxel::ColumnBlock m_block;
  FreeSpanFinder m_spans;
  Row m_row;
};

}  // namespace mrpt_mapconv::freespace
