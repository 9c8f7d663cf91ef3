#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <array>

#include "BlockJob.h"
#include "DropWalk.h"
#include "FloorTile.h"
#include "SlopeFilter.h"

namespace mrpt_mapconv::freespace
{
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
  void writeUnsupported(const BlockPlace& place, const voxel::ColumnMask& columns,
                        const voxel::ColumnMask& supported);
  void writeSupported(const BlockPlace& place, const voxel::ColumnMask& columns,
                      const voxel::ColumnMask& blocked);
  voxel::ColumnMask stepsOrDrops(voxel::BlockKey block, const voxel::ColumnMask& columns);

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
