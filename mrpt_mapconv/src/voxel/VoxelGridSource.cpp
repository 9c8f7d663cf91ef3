#include <mrpt_mapconv/voxel/VoxelGridSource.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "../grid/Wide.h"

namespace mrpt_mapconv::voxel
{
namespace
{
using Slot = VoxelGrid::Slot;

/** The voxels of a column, a bit each. */
struct ColumnBits
{
  std::uint32_t free, occupied;
};
using BrickColumns = std::array<ColumnBits, kBrickColumns>;

constexpr std::uint32_t kAllVoxels = (1u << kBrickSide) - 1;

ColumnBits bitsOf(float logOdds, float occupiedFrom)
{
  if (!isTouched(logOdds)) return {0, 0};
  return logOdds >= occupiedFrom ? ColumnBits{0, kAllVoxels} : ColumnBits{kAllVoxels, 0};
}

MRPT_MAPCONV_WIDE
void readColumns(const float* column, float occupiedFrom, ColumnBits* bits, std::size_t count)
{
  for (std::size_t c = 0; c < count; ++c, column += kBrickSide)
  {
    std::int32_t known = 0, occupied = 0;
    for (std::int32_t i = 0; i < kBrickSide; ++i)
    {
      std::int32_t pattern;
      std::memcpy(&pattern, column + i, sizeof(pattern));
      known |= pattern != kUntouchedBits ? 1 << i : 0;
      occupied |= column[i] >= occupiedFrom ? 1 << i : 0;
    }
    occupied &= known;
    bits[c] = {static_cast<std::uint32_t>(known & ~occupied), static_cast<std::uint32_t>(occupied)};
  }
}

/** Where the known voxels of a slot lie within it, both ends included. */
struct Extent
{
  std::int32_t xMin = kBrickSide, xMax = -1, yMin = kBrickSide, yMax = -1, zMax = -1;
};

Extent extentOf(const Slot& slot)
{
  constexpr std::int32_t last = kBrickSide - 1;
  if (!slot.brick) return isTouched(slot.value) ? Extent{0, last, 0, last, last} : Extent{};
  BrickColumns bits;
  readColumns(slot.brick->logOdds.data(), 0, bits.data(), bits.size());
  Extent extent;
  std::uint32_t any = 0;
  for (std::int32_t c = 0; c < kBrickColumns; ++c)
  {
    const auto& column = bits[static_cast<std::size_t>(c)];
    const std::uint32_t known = column.free | column.occupied;
    if (!known) continue;
    any |= known;
    const std::int32_t x = c >> kBrickBits, y = c & last;
    extent.xMin = std::min(extent.xMin, x);
    extent.xMax = x;
    extent.yMin = std::min(extent.yMin, y);
    extent.yMax = std::max(extent.yMax, y);
  }
  if (any) extent.zMax = 31 - __builtin_clz(any);
  return extent;
}
}  // namespace

VoxelGridSource::VoxelGridSource(const VoxelGrid& grid)
    : m_grid(grid),
      m_zMin(std::numeric_limits<std::int32_t>::max()),
      m_zMax(std::numeric_limits<std::int32_t>::min())
{
  for (const auto& [key, region] : grid.table().regions())
  {
    m_zMin = std::min(m_zMin, key.z);
    m_zMax = std::max(m_zMax, key.z);
  }
}

std::optional<KeyRect> VoxelGridSource::bounds() const
{
  constexpr auto big = std::numeric_limits<std::int32_t>::max();
  KeyRect box{big, big, -big - 1, -big - 1};
  m_grid.table().forEachSlot(
      [&box](const VoxelKey& origin, const Slot& slot)
      {
        constexpr std::int32_t last = kBrickSide - 1;
        const bool addsNothing = origin.x >= box.xMin && origin.x + last <= box.xMax &&
                                 origin.y >= box.yMin && origin.y + last <= box.yMax;
        if (addsNothing || slot.isUntouched()) return;
        const Extent extent = extentOf(slot);
        if (extent.zMax < 0) return;
        box = {
            std::min(box.xMin, origin.x + extent.xMin), std::min(box.yMin, origin.y + extent.yMin),
            std::max(box.xMax, origin.x + extent.xMax), std::max(box.yMax, origin.y + extent.yMax)};
      });
  if (box.xMin > box.xMax) return std::nullopt;
  const auto isWide = [](std::int64_t low, std::int64_t high) { return high - low >= big; };
  if (isWide(box.xMin, box.xMax) || isWide(box.yMin, box.yMax))
    throw std::runtime_error("the voxel map is 2^31 voxels wide or more; larger voxels would do");
  return box;
}

std::optional<std::int32_t> VoxelGridSource::top() const
{
  std::optional<std::int32_t> top;
  m_grid.table().forEachSlot(
      [&top](const VoxelKey& origin, const Slot& slot)
      {
        if (slot.isUntouched() || (top && origin.z + kBrickSide - 1 <= *top)) return;
        const Extent extent = extentOf(slot);
        if (extent.zMax >= 0) top = std::max(top, std::optional(origin.z + extent.zMax));
      });
  return top;
}

void VoxelGridSource::read(ColumnBlock& block) const
{
  constexpr std::int32_t blocksBits = kRegionVoxelBits - 5, bricks = kBlockSide / kBrickSide;
  const BlockKey key = block.key();
  struct Piece
  {
    std::int32_t x, y, z;  // of the lowest voxel: in the block, and its key
    const Slot* slot;
  };
  std::vector<Piece> pieces;  // from the lowest up
  for (std::int32_t z = m_zMin; z <= m_zMax; ++z)
  {
    const auto* region = m_grid.table().find({key.x >> blocksBits, key.y >> blocksBits, z});
    if (!region) continue;
    for (std::int32_t up = 0; up < kRegionSide; ++up)
      for (std::int32_t x = 0; x < bricks; ++x)
        for (std::int32_t y = 0; y < bricks; ++y)
        {
          const VoxelKey lowest{key.x * kBlockSide + x * kBrickSide,
                                key.y * kBlockSide + y * kBrickSide,
                                z * (1 << kRegionVoxelBits) + up * kBrickSide};
          const Slot& slot = (*region)[brickIndex(lowest)];
          if (!slot.isUntouched())
            pieces.push_back({x * kBrickSide, y * kBrickSide, lowest.z, &slot});
        }
  }
  if (pieces.empty()) return;

  block.setHeight(pieces.front().z, pieces.back().z + kBrickSide);
  const float occupiedFrom = m_grid.occupiedFrom();
  BrickColumns bits;
  for (const Piece& piece : pieces)
  {
    if (!piece.slot->brick) bits.fill(bitsOf(piece.slot->value, occupiedFrom));
    for (std::int32_t x = 0; x < kBrickSide; ++x)
    {
      std::uint32_t wanted = 0;  // bit y
      for (std::int32_t y = 0; y < kBrickSide; ++y)
        wanted |= (block.wanted()[static_cast<std::size_t>(piece.y + y)] >> (piece.x + x) & 1u)
                  << y;
      if (!wanted) continue;
      const std::int32_t first = __builtin_ctz(wanted), end = 32 - __builtin_clz(wanted);
      const auto at = static_cast<std::size_t>(x * kBrickSide + first);
      if (piece.slot->brick)
        readColumns(piece.slot->brick->logOdds.data() + at * kBrickSide, occupiedFrom, &bits[at],
                    static_cast<std::size_t>(end - first));
      for (std::int32_t y = first; y < end; ++y)
      {
        const ColumnBits& column = bits[static_cast<std::size_t>(x * kBrickSide + y)];
        if (wanted >> y & 1u)
          block.markColumn(piece.x + x, piece.y + y, piece.z, column.free, column.occupied);
      }
    }
  }
}

}  // namespace mrpt_mapconv::voxel
