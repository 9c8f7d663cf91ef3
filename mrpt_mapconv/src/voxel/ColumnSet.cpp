#include <mrpt_mapconv/voxel/ColumnSet.h>

#include <algorithm>
#include <limits>

namespace mrpt_mapconv::voxel
{
namespace
{
std::int32_t blockOf(std::int32_t key) { return key >> 5; }
std::int32_t insideBlock(std::int32_t key) { return key & 31; }

/** Bits [begin, end) of a row that starts at key `origin`, as far as they fall into it. */
std::uint32_t rowBits(std::int32_t begin, std::int32_t end, std::int32_t origin)
{
  const std::int32_t first = std::max(begin - origin, 0);
  const std::int32_t last = std::min(end - origin, kBlockSide);
  if (first >= last) return 0;
  return (kFullRow >> (kBlockSide - (last - first))) << first;
}

/** A row with every set bit spread by `radius` (< 32) to both sides: the three words that it then
 * touches, left neighbour's, own and right neighbour's. */
std::array<std::uint32_t, 3> spread(std::uint32_t row, std::int32_t radius)
{
  __extension__ using Wide = unsigned __int128;
  Wide bits = Wide{row} << kBlockSide;
  for (std::int32_t done = 0; done < radius;)
  {
    const std::int32_t step = std::min(radius - done, 2 * done + 1);
    bits |= (bits << step) | (bits >> step);
    done += step;
  }
  return {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> kBlockSide),
          static_cast<std::uint32_t>(bits >> (2 * kBlockSide))};
}

ColumnSet::Blocks dilatedInX(const ColumnSet::Blocks& blocks, std::int32_t radius)
{
  ColumnSet::Blocks out;
  for (const auto& [key, mask] : blocks)
    for (std::size_t y = 0; y < mask.size(); ++y)
    {
      if (!mask[y]) continue;
      const auto words = spread(mask[y], radius);
      for (std::int32_t side = 0; side < 3; ++side)
        if (const std::uint32_t word = words[static_cast<std::size_t>(side)]; word)
          out[{key.x + side - 1, key.y}][y] |= word;
    }
  return out;
}

ColumnSet::Blocks dilatedInY(const ColumnSet::Blocks& blocks, std::int32_t radius)
{
  ColumnSet::Blocks out;
  for (const auto& [key, mask] : blocks)
    for (std::int32_t side = -1; side <= 1; ++side)
    {
      ColumnMask shifted{};
      bool any = false;
      for (std::int32_t y = 0; y < kBlockSide; ++y)
      {
        if (!mask[static_cast<std::size_t>(y)]) continue;
        const std::int32_t begin = std::max(y - radius - side * kBlockSide, 0);
        const std::int32_t end = std::min(y + radius + 1 - side * kBlockSide, kBlockSide);
        for (std::int32_t to = begin; to < end; ++to)
          shifted[static_cast<std::size_t>(to)] |= mask[static_cast<std::size_t>(y)];
        any |= begin < end;
      }
      if (!any) continue;
      auto& target = out[{key.x, key.y + side}];
      for (std::size_t y = 0; y < target.size(); ++y) target[y] |= shifted[y];
    }
  return out;
}
}  // namespace

ColumnSet ColumnSet::of(const grid::GridFrame& frame)
{
  ColumnSet set;
  if (frame.empty()) return set;
  for (std::int32_t by = blockOf(frame.y0); by <= blockOf(frame.yEnd() - 1); ++by)
    for (std::int32_t bx = blockOf(frame.x0); bx <= blockOf(frame.xEnd() - 1); ++bx)
    {
      auto& mask = set.m_blocks[{bx, by}];
      const std::uint32_t row = rowBits(frame.x0, frame.xEnd(), bx * kBlockSide);
      for (std::int32_t y = 0; y < kBlockSide; ++y)
      {
        const std::int32_t ky = by * kBlockSide + y;
        mask[static_cast<std::size_t>(y)] = ky >= frame.y0 && ky < frame.yEnd() ? row : 0;
      }
    }
  return set;
}

void ColumnSet::insert(std::int32_t kx, std::int32_t ky)
{
  m_blocks[{blockOf(kx), blockOf(ky)}][static_cast<std::size_t>(insideBlock(ky))] |=
      1u << insideBlock(kx);
}

void ColumnSet::insert(const BlockKey& block, const ColumnMask& columns)
{
  ColumnMask& own = m_blocks[block];
  for (std::size_t y = 0; y < own.size(); ++y) own[y] |= columns[y];
}

void ColumnSet::insert(const ColumnSet& other)
{
  for (const auto& [key, mask] : other.m_blocks) insert(key, mask);
}

bool ColumnSet::contains(std::int32_t kx, std::int32_t ky) const
{
  const auto it = m_blocks.find({blockOf(kx), blockOf(ky)});
  return it != m_blocks.end() &&
         (it->second[static_cast<std::size_t>(insideBlock(ky))] >> insideBlock(kx) & 1u);
}

std::size_t ColumnSet::size() const
{
  std::size_t count = 0;
  for (const auto& [key, mask] : m_blocks)
    for (const auto row : mask) count += static_cast<std::size_t>(__builtin_popcount(row));
  return count;
}

ColumnSet ColumnSet::dilated(std::int32_t radius) const
{
  ColumnSet set = *this;
  for (std::int32_t left = radius; left > 0;)
  {
    const std::int32_t step = std::min(left, kBlockSide - 1);
    set.m_blocks = dilatedInY(dilatedInX(set.m_blocks, step), step);
    left -= step;
  }
  return set;
}

ColumnSet ColumnSet::clipped(const grid::GridFrame& frame) const
{
  ColumnSet set;
  for (const auto& [key, mask] : m_blocks)
  {
    const std::uint32_t row = rowBits(frame.x0, frame.xEnd(), key.x * kBlockSide);
    ColumnMask kept{};
    bool any = false;
    for (std::int32_t y = 0; y < kBlockSide; ++y)
    {
      const std::int32_t ky = key.y * kBlockSide + y;
      if (ky < frame.y0 || ky >= frame.yEnd()) continue;
      const auto at = static_cast<std::size_t>(y);
      kept[at] = mask[at] & row;
      any |= kept[at] != 0;
    }
    if (any) set.m_blocks.emplace(key, kept);
  }
  return set;
}

grid::GridFrame ColumnSet::bounds(double resolution) const
{
  constexpr auto big = std::numeric_limits<std::int32_t>::max();
  std::int32_t xMin = big, yMin = big, xMax = -big, yMax = -big;
  for (const auto& [key, mask] : m_blocks)
  {
    std::uint32_t any = 0;
    for (std::int32_t y = 0; y < kBlockSide; ++y)
    {
      const std::uint32_t row = mask[static_cast<std::size_t>(y)];
      if (!row) continue;
      any |= row;
      yMin = std::min(yMin, key.y * kBlockSide + y);
      yMax = std::max(yMax, key.y * kBlockSide + y);
    }
    if (!any) continue;
    xMin = std::min(xMin, key.x * kBlockSide + __builtin_ctz(any));
    xMax = std::max(xMax, key.x * kBlockSide + 31 - __builtin_clz(any));
  }
  if (xMin > xMax) return {resolution, 0, 0, 0, 0};
  return {resolution, xMin, yMin, xMax - xMin + 1, yMax - yMin + 1};
}

namespace
{
/** Every bit within `radius` of a set one. */
std::uint32_t spreadInside(std::uint32_t row, std::int32_t radius)
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
  if (blocks == 0) return spreadInside(other, radius);
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

ColumnMask columnsNear(const ColumnSet::Blocks& set, BlockKey block, std::int32_t radius)
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

}  // namespace mrpt_mapconv::voxel
