#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <array>
#include <vector>

#include "ColumnRuns.h"
#include "FloorTile.h"
#include "SlopeFilter.h"

namespace mrpt_mapconv::freespace
{
/** What has to be done in one block of columns, and what the first pass has found there. */
struct BlockJob
{
  voxel::BlockKey key;
  voxel::ColumnMask changed{};  //!< columns whose voxels may have changed: to be read
  voxel::ColumnMask reach{};  //!< columns whose layers may depend on those, here or in other blocks

  voxel::ColumnMask newFloor{};    //!< of `changed`: the floor differs from what the layer held
  voxel::ColumnMask newSpan{};     //!< of `changed`: floor or ceiling differs
  std::vector<OccupiedRun> walls;  //!< occupied runs of columns that are not free but may touch a
                                   //!< free one; column by column
};

/** The columns whose floor or free range the first pass has found to differ. */
struct Differences
{
  voxel::ColumnSet::Blocks newFloor, newSpan;

  void note(const BlockJob& job);
  void forget(voxel::BlockKey key);
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

/** First pass over a block: the changed columns' voxels → floor, ceiling and walls. */
class HeightPass
{
 public:
  /** \param blank whether the layers hold nothing yet: all unknown */
  HeightPass(const voxel::VoxelSource& source, const ConversionParams& params, Layers& layers,
             bool blank);
  void run(BlockJob& job);

 private:
  voxel::ColumnMask writeHeights(BlockJob& job);
  void collectWalls(BlockJob& job, const voxel::ColumnMask& free);

  const voxel::VoxelSource& m_source;
  Layers& m_layers;
  bool m_blank;
  voxel::ColumnBlock m_block;
  FreeSpanFinder m_spans;
};

/** Second pass, once the floors around the block are known: slope and both occupancies of the
 * changed columns and of those that depend on a difference nearby. */
class OccupancyPass
{
 public:
  OccupancyPass(const voxel::VoxelSource& source, const ConversionParams& params,
                const Differences& differences, Layers& layers);
  void run(BlockJob& job);

 private:
  voxel::ColumnMask columnsBesideNewSpans(const BlockJob& job) const;
  voxel::ColumnMask withoutFloor(const voxel::ColumnMask& columns, const BlockPlace& place) const;
  void readWalls(const voxel::ColumnMask& columns, BlockJob& job);
  void writeAerial(const BlockJob& job, const voxel::ColumnMask& columns);
  void writeGroundWithoutFloor(const BlockPlace& place, const voxel::ColumnMask& columns);
  void writeSlopeAndGround(const BlockPlace& place, const voxel::ColumnMask& columns);
  float wallOccupancy(const BlockPlace& place, std::int32_t x, std::int32_t y,
                      const OccupiedRun* begin, const OccupiedRun* end) const;
  bool hasStep(const std::int32_t* floor) const;

  const voxel::VoxelSource& m_source;
  const ConversionParams& m_params;
  const Differences& m_differences;
  Layers& m_layers;
  bool m_checkSteps;
  std::int32_t m_maxStep;  // voxels
  double m_inverseResolution;
  voxel::ColumnBlock m_block;
  FloorTile m_floors;
  SlopeFilter m_slopeFilter;
  std::array<double, voxel::kBlockColumns> m_slope{};
};

}  // namespace mrpt_mapconv::freespace
