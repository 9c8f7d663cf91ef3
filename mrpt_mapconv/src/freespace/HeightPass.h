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
  /** \param hidden tops under the floors that the layers hold
   * \param blank whether the layers hold nothing yet: all unknown */
  HeightPass(const voxel::VoxelSource& source, const ConversionParams& params,
             const HiddenTops& hidden, Layers& layers, bool blank);
  void run(BlockJob& job);

 private:
  /** What is found in one row of the block. Evidence is raw: what is inferred comes later. */
  struct Row
  {
    RowValues floor{}, ceiling{}, support{}, evidence{};
    std::uint32_t free = 0;  //!< columns with a kept free range
  };

  void findRow(std::int32_t y, std::uint32_t columns);
  std::uint32_t findHidden(std::int32_t y, BlockJob& job) const;
  voxel::ColumnMask writeHeights(BlockJob& job);
  void collectWalls(BlockJob& job, const voxel::ColumnMask& free);

  const voxel::VoxelSource& m_source;
  const HiddenTops& m_hidden;
  Layers& m_layers;
  bool m_blank, m_supportIsFloor;
  voxel::ColumnBlock m_block;
  FreeSpanFinder m_spans;
  Row m_row;
};

}  // namespace mrpt_mapconv::freespace
