#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <algorithm>
#include <bitset>

#include "ReadBlocks.h"

namespace mrpt_mapconv::voxel
{
namespace
{
/** z key of the block's highest known voxel; nothing if none is known. */
std::optional<std::int32_t> topOf(const ColumnBlock& block)
{
  for (std::int32_t w = block.words() - 1; w >= 0; --w)
  {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(w) * kBlockColumns;
    std::uint64_t known = 0;
    for (std::int32_t c = 0; c < kBlockColumns; ++c)
      known |= block.freePlane()[at + c] | block.occupiedPlane()[at + c];
    if (known) return block.zMin() + 64 * w + 63 - __builtin_clzll(known);
  }
  return std::nullopt;
}

bool hasFree(const ColumnBlock& block)
{
  const std::uint64_t* plane = block.freePlane();
  const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(block.words()) * kBlockColumns;
  return std::any_of(plane, plane + size, [](std::uint64_t word) { return word != 0; });
}
}  // namespace

std::optional<std::int32_t> VoxelSource::top() const
{
  std::optional<std::int32_t> top;
  readBlocks(*this,
             [&top](const ColumnBlock& block)
             {
               top = std::max(top, topOf(block));  // nothing is less than any key
               return false;
             });
  return top;
}

std::size_t knownVoxels(const VoxelSource& source)
{
  std::size_t known = 0;
  readBlocks(source,
             [&known](const ColumnBlock& block)
             {
               const std::ptrdiff_t size =
                   static_cast<std::ptrdiff_t>(block.words()) * kBlockColumns;
               for (std::ptrdiff_t i = 0; i < size; ++i)
                 known += std::bitset<64>(block.freePlane()[i] | block.occupiedPlane()[i]).count();
               return false;
             });
  return known;
}

bool hasFreeVoxel(const VoxelSource& source)
{
  bool found = false;
  readBlocks(source, [&found](const ColumnBlock& block) { return found = hasFree(block); });
  return found;
}

}  // namespace mrpt_mapconv::voxel
