#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <array>
#include <vector>

#include "ColumnRuns.h"
#include "DropWalk.h"
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

  voxel::ColumnMask newFloor{};    //!< of `changed`: the floor or its evidence differs from what
                                   //!< the layers held
  voxel::ColumnMask newSpan{};     //!< of `changed`: floor or ceiling differs
  std::vector<OccupiedRun> walls;  //!< occupied runs of columns that are not free but may touch a
                                   //!< free one; column by column
};

/** The columns whose floor or free range the first pass has found to differ. */
struct Differences
{
  voxel::ColumnSet newFloor;         //!< of all blocks; empty if the layers were blank
  voxel::ColumnSet::Blocks newSpan;  //!< of the blocks that the second pass still needs

  void note(const BlockJob& job, bool blank);
  void forget(voxel::BlockKey key) { newSpan.erase(key); }
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

/** First pass over a block: the changed columns' voxels → floor, ceiling, walls, evidence, and the
 * support of seen cells. */
class HeightPass
{
 public:
  /** \param blank whether the layers hold nothing yet: all unknown */
  HeightPass(const voxel::VoxelSource& source, const ConversionParams& params, Layers& layers,
             bool blank);
  void run(BlockJob& job);

 private:
  voxel::ColumnMask writeHeights(BlockJob& job);
  bool writeGround(bool newFloor, float floor, float now, float& known, float& support);
  float evidenceOf(std::int32_t column, const FreeSpan& span) const;
  void collectWalls(BlockJob& job, const voxel::ColumnMask& free);

  const voxel::VoxelSource& m_source;
  Layers& m_layers;
  bool m_blank, m_supportIsFloor;
  voxel::ColumnBlock m_block;
  FreeSpanFinder m_spans;
};

/** Second pass, once the floors around the block are known: the aerial occupancy of the changed
 * columns and of those that touch one whose free range differs. */
class AerialPass
{
 public:
  AerialPass(const voxel::VoxelSource& source, const ConversionParams& params,
             const Differences& differences, Layers& layers);
  void run(BlockJob& job);

 private:
  voxel::ColumnMask columnsBesideNewSpans(const BlockJob& job) const;
  voxel::ColumnMask withoutFloor(const voxel::ColumnMask& columns, const BlockPlace& place) const;
  void readWalls(const voxel::ColumnMask& columns, BlockJob& job);
  void writeAerial(const BlockJob& job, const voxel::ColumnMask& columns);
  float wallOccupancy(const BlockPlace& place, std::int32_t x, std::int32_t y,
                      const OccupiedRun* begin, const OccupiedRun* end) const;

  const voxel::VoxelSource& m_source;
  const ConversionParams& m_params;
  const Differences& m_differences;
  Layers& m_layers;
  double m_inverseResolution;
  voxel::ColumnBlock m_block;
  FloorTile m_floors;
};

/** Third pass, once all supports and the aerial occupancy are known: slope and ground occupancy. It
 * looks at layers only. */
class GroundPass
{
 public:
  GroundPass(const ConversionParams& params, Layers& layers);
  void run(voxel::BlockKey block, const voxel::ColumnMask& columns);

  /** How far away a cell can lie that a cell's slope or ground occupancy depends on [cells]. */
  std::int32_t reach() const;

 private:
  voxel::ColumnMask withSupport() const;
  void writeUnsupported(const BlockPlace& place, const voxel::ColumnMask& columns);
  bool hasStepOrDrop(std::int32_t x, std::int32_t y, const BlockPlace& place) const;

  const ConversionParams& m_params;
  Layers& m_layers;
  bool m_checkSteps;
  std::int32_t m_maxStep;  // 64ths of a voxel
  DropWalk m_drops;
  FloorTile m_supports;  // in 64ths of a voxel
  FloorTile m_floors;    // likewise
  SlopeFilter m_slopeFilter;
  std::array<double, voxel::kBlockColumns> m_slope{};
};

}  // namespace mrpt_mapconv::freespace
