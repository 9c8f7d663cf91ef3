#pragma once

#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <array>
#include <cstddef>
#include <optional>

#include "HeightRange.h"

namespace mrpt_mapconv::path
{
/** Occupied voxels of single columns. The blocks looked at last are kept, so columns are best asked
 * for in the order of a way. */
class VoxelLookup
{
 public:
  explicit VoxelLookup(const voxel::VoxelSource& source) : m_source(source) {}

  /** The lowest one that a body meets in a column; touching is no meeting. */
  std::optional<HeightRange> lowestOccupied(std::int32_t kx, std::int32_t ky,
                                            const HeightRange& body);

 private:
  /** The lowest occupied one among the voxels [zBegin, zEnd) of a column. */
  std::optional<std::int32_t> lowestOccupied(std::int32_t kx, std::int32_t ky, std::int32_t zBegin,
                                             std::int32_t zEnd);
  const voxel::ColumnBlock& blockAt(std::int32_t kx, std::int32_t ky);

  const voxel::VoxelSource& m_source;
  std::array<std::optional<voxel::ColumnBlock>, 4> m_blocks;  //!< as many as meet at a corner
  std::size_t m_oldest = 0;
};

}  // namespace mrpt_mapconv::path
