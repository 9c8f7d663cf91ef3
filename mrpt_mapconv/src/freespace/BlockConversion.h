#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <array>
#include <vector>

#include "ColumnRuns.h"
#include "FloorTile.h"
#include "SlopeFilter.h"

namespace mrpt_mapconv::freespace
{
/** What has to be done in one block of columns. */
struct BlockJob
{
  voxel::BlockKey key;
  voxel::ColumnMask read{};     //!< columns whose voxels, heights and aerial occupancy are due
  voxel::ColumnMask touched{};  //!< columns whose slope and ground occupancy are due; holds `read`
  std::vector<OccupiedRun>
      walls;  //!< occupied runs of read columns that are not free but may touch a free one
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

/** First pass over a block: voxels → floor, ceiling and walls. */
class HeightPass
{
 public:
  HeightPass(const voxel::VoxelSource& source, const ConversionParams& params, Layers& layers);
  void run(BlockJob& job);

 private:
  voxel::ColumnMask writeHeights(const BlockJob& job);
  void collectWalls(BlockJob& job, const voxel::ColumnMask& free);

  const voxel::VoxelSource& m_source;
  Layers& m_layers;
  voxel::ColumnBlock m_block;
  FreeSpanFinder m_spans;
};

/** Second pass, once the floors around the block are known: slope and both occupancies. */
class OccupancyPass
{
 public:
  OccupancyPass(const ConversionParams& params, Layers& layers);
  void run(const BlockJob& job);

 private:
  void writeAerial(const BlockJob& job);
  void writeSlopeAndGround(const BlockJob& job);
  float wallOccupancy(const BlockPlace& place, std::int32_t x, std::int32_t y,
                      const OccupiedRun* begin, const OccupiedRun* end) const;
  bool hasStep(const std::int32_t* floor) const;

  const ConversionParams& m_params;
  Layers& m_layers;
  bool m_checkSteps;
  std::int32_t m_maxStep;  // voxels
  double m_inverseResolution;
  FloorTile m_floors;
  SlopeFilter m_slopeFilter;
  std::array<double, voxel::kBlockColumns> m_slope{};
};

}  // namespace mrpt_mapconv::freespace
