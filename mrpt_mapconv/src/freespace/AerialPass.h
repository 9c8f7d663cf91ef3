#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <array>

#include "BlockJob.h"

namespace mrpt_mapconv::freespace
{
/** Second pass, once the floors around the block are known: the aerial occupancy of the changed
 * columns and of those that touch one whose free range differs. */
class AerialPass
{
 public:
  /** \param newSpan columns whose free range differs, of the block and those around it
   * \param blank whether there was no aerial occupancy before */
  AerialPass(const voxel::VoxelSource& source, const ConversionParams& params,
             const voxel::ColumnSet::Blocks& newSpan, Layers& layers, bool blank);
  void run(BlockJob& job);

 private:
  voxel::ColumnMask columnsBesideNewSpans(const BlockJob& job) const;
  voxel::ColumnMask withoutFloor(const voxel::ColumnMask& columns, const BlockPlace& place) const;
  void readWalls(const voxel::ColumnMask& columns, BlockJob& job);
  void findAerial(const BlockJob& job, const voxel::ColumnMask& columns);
  float wallOccupancy(std::int32_t ix, std::int32_t iy, const OccupiedRun* begin,
                      const OccupiedRun* end) const;
  void writeAerial(const voxel::ColumnMask& columns, BlockJob& job);

  const voxel::VoxelSource& m_source;
  const ConversionParams& m_params;
  const voxel::ColumnSet::Blocks& m_newSpan;
  Layers& m_layers;
  bool m_blank;
  double m_inverseResolution;
  voxel::ColumnBlock m_block;
  std::array<float, voxel::kBlockColumns> m_aerial{};
};

}  // namespace mrpt_mapconv::freespace
