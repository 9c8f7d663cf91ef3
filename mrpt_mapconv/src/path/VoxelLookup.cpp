#include "VoxelLookup.h"

#include <algorithm>
#include <cmath>

#include "ColumnMarks.h"
#include "NearestHeight.h"

namespace mrpt_mapconv::path
{
using voxel::ColumnBlock;
using voxel::kBlockColumns;
using voxel::kBlockSide;

std::optional<std::int32_t> VoxelLookup::lowestOccupied(std::int32_t kx, std::int32_t ky,
                                                        std::int32_t zBegin, std::int32_t zEnd)
{
  const ColumnBlock& block = blockAt(kx, ky);
  const std::int32_t first = std::max(zBegin - block.zMin(), 0);
  const std::int32_t end = std::min(zEnd - block.zMin(), 64 * block.words());
  const std::int32_t column =
      (ky - block.key().y * kBlockSide) * kBlockSide + kx - block.key().x * kBlockSide;
  for (std::int32_t z = first; z < end; z = (z | 63) + 1)
  {
    const std::uint64_t word = block.occupiedPlane()[(z >> 6) * kBlockColumns + column] >> (z & 63);
    if (word == 0) continue;
    const std::int32_t found = z + __builtin_ctzll(word);
    return found < end ? std::optional(found + block.zMin()) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<HeightRange> VoxelLookup::lowestOccupied(std::int32_t kx, std::int32_t ky,
                                                       const HeightRange& body)
{
  const double resolution = m_source.resolution();
  const auto begin = static_cast<std::int32_t>(std::floor((body.low + kHeightSlack) / resolution));
  const auto end = static_cast<std::int32_t>(std::ceil((body.high - kHeightSlack) / resolution));
  const auto found = lowestOccupied(kx, ky, begin, end);
  if (!found) return std::nullopt;
  return HeightRange{*found * resolution, (*found + 1) * resolution};
}

const ColumnBlock& VoxelLookup::blockAt(std::int32_t kx, std::int32_t ky)
{
  const voxel::BlockKey key{blockOf(kx), blockOf(ky)};
  for (const auto& block : m_blocks)
    if (block && block->key() == key) return *block;
  auto& block = m_blocks[m_oldest];
  m_oldest = (m_oldest + 1) % m_blocks.size();
  if (!block) block.emplace();
  voxel::ColumnMask all;
  all.fill(voxel::kFullRow);
  block->start(key, all);
  m_source.read(*block);
  return *block;
}

}  // namespace mrpt_mapconv::path
