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

void ColumnSet::insert(const ColumnSet& other)
{
  for (const auto& [key, mask] : other.m_blocks)
  {
    ColumnMask& own = m_blocks[key];
    for (std::size_t y = 0; y < own.size(); ++y) own[y] |= mask[y];
  }
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

}  // namespace mrpt_mapconv::voxel
