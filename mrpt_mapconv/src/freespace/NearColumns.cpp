#include "NearColumns.h"

#include <algorithm>

namespace mrpt_mapconv::freespace
{
using voxel::ColumnMask;
using voxel::kBlockSide;
using voxel::kFullRow;

namespace
{
/** Every bit within `radius` of a set one. */
std::uint32_t spread(std::uint32_t row, std::int32_t radius)
{
  for (std::int32_t done = 0; done < std::min(radius, kBlockSide - 1);)
  {
    const std::int32_t step = std::min(radius - done, done + 1);
    row |= row << step | row >> step;
    done += step;
  }
  return row;
}

/** The bits of a row within `radius` of a set bit of `other`, the row `blocks` to the right. */
std::uint32_t spreadFrom(std::uint32_t other, std::int32_t blocks, std::int32_t radius)
{
  if (!other) return 0;
  if (blocks == 0) return spread(other, radius);
  if (blocks > 0)  // its lowest bit reaches farthest
  {
    const std::int32_t first = blocks * kBlockSide + __builtin_ctz(other) - radius;
    return first < kBlockSide ? kFullRow << std::max(first, 0) : 0;
  }
  const std::int32_t last = blocks * kBlockSide + 31 - __builtin_clz(other) + radius;
  return last >= 0 ? kFullRow >> std::max(31 - last, 0) : 0;
}

/** Adds the columns of a block near those of `other`, which lies (dx, dy) blocks away. */
void addNear(const ColumnMask& other, std::int32_t dx, std::int32_t dy, std::int32_t radius,
             ColumnMask& near)
{
  const std::int32_t up = dy * kBlockSide;
  const std::int32_t yEnd = std::min(kBlockSide, kBlockSide + radius - up);
  for (std::int32_t y = std::max(0, -radius - up); y < yEnd; ++y)
  {
    const std::uint32_t row = spreadFrom(other[static_cast<std::size_t>(y)], dx, radius);
    if (!row) continue;
    const std::int32_t begin = std::max(up + y - radius, 0);
    const std::int32_t end = std::min(up + y + radius + 1, kBlockSide);
    for (std::int32_t to = begin; to < end; ++to) near[static_cast<std::size_t>(to)] |= row;
  }
}

bool full(const ColumnMask& mask)
{
  return std::all_of(mask.begin(), mask.end(), [](auto row) { return row == kFullRow; });
}
}  // namespace

ColumnMask columnsNear(const voxel::ColumnSet::Blocks& set, voxel::BlockKey block,
                       std::int32_t radius)
{
  ColumnMask near{};
  if (const auto own = set.find(block); own != set.end()) addNear(own->second, 0, 0, radius, near);
  if (full(near)) return near;
  const std::int32_t blocks = (radius + kBlockSide - 1) / kBlockSide;
  for (std::int32_t dy = -blocks; dy <= blocks; ++dy)
    for (std::int32_t dx = -blocks; dx <= blocks; ++dx)
      if (const auto it = set.find({block.x + dx, block.y + dy}); it != set.end())
        addNear(it->second, dx, dy, radius, near);
  return near;
}

}  // namespace mrpt_mapconv::freespace
