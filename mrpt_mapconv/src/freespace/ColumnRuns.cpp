#include "ColumnRuns.h"

#include <algorithm>

#include "ColumnMasks.h"

namespace mrpt_mapconv::freespace
{
using voxel::kBlockColumns;

namespace
{
/** plane &= plane >> shift, each of `count` columns on its own, over all its words. */
void andShifted(std::uint64_t* plane, std::int32_t count, std::int32_t words, std::int32_t shift)
{
  const std::int32_t skip = shift / 64;
  const int down = shift % 64;
  for (std::int32_t w = 0; w < words; ++w)
  {
    std::uint64_t* to = plane + static_cast<std::ptrdiff_t>(w) * kBlockColumns;
    const std::uint64_t* low = to + static_cast<std::ptrdiff_t>(skip) * kBlockColumns;
    const std::uint64_t* high = low + kBlockColumns;
    if (w + skip >= words)
      std::fill_n(to, count, 0);
    else if (down == 0)
      for (std::int32_t c = 0; c < count; ++c) to[c] &= low[c];
    else if (w + skip + 1 >= words)
      for (std::int32_t c = 0; c < count; ++c) to[c] &= low[c] >> down;
    else
      for (std::int32_t c = 0; c < count; ++c) to[c] &= (low[c] >> down) | (high[c] << (64 - down));
  }
}

/** The columns of a block's row with any bit in the words of a plane. */
std::uint32_t columnsWithBits(const std::uint64_t* plane, std::int32_t words, std::int32_t y)
{
  if (words == 0) return 0;
  std::array<std::uint32_t, voxel::kBlockSide> any;  // bits of any word, its halves on each other
  const std::uint64_t* row = plane + y * voxel::kBlockSide;
  const auto folded = [&](std::size_t x)
  { return static_cast<std::uint32_t>(row[x]) | static_cast<std::uint32_t>(row[x] >> 32); };
  for (std::size_t x = 0; x < any.size(); ++x) any[x] = folded(x);
  for (std::int32_t w = 1; w < words; ++w)
  {
    row += kBlockColumns;
    for (std::size_t x = 0; x < any.size(); ++x) any[x] |= folded(x);
  }
  return rowWhere([&](std::int32_t x) { return any[static_cast<std::size_t>(x)] != 0; });
}

void appendRunsOf(const voxel::ColumnBlock& block, std::int32_t column,
                  std::vector<OccupiedRun>& runs)
{
  const std::uint64_t* plane = block.occupiedPlane() + column;
  const std::size_t before = runs.size();
  for (std::int32_t w = 0; w < block.words(); ++w)
  {
    std::uint64_t word = plane[w * kBlockColumns];
    const std::int32_t zWord = block.zMin() + 64 * w;
    while (word)
    {
      const int begin = __builtin_ctzll(word);
      const std::uint64_t free = ~(word >> begin);
      const int length = free ? std::min(__builtin_ctzll(free), 64 - begin) : 64 - begin;
      if (runs.size() > before && runs.back().end == zWord + begin)
        runs.back().end += length;  // goes on from the word below
      else
        runs.push_back({column, zWord + begin, zWord + begin + length});
      if (begin + length == 64) break;
      word &= ~std::uint64_t{0} << (begin + length);
    }
  }
}
}  // namespace

void FreeSpanFinder::start(const voxel::ColumnBlock& block)
{
  m_zMin = block.zMin();
  m_words = block.words();
  if (m_minRun > 64 * m_words) m_words = 0;  // no range can be that high
  const std::int32_t first = block.rowBegin() * voxel::kBlockSide;
  const std::int32_t count = block.rowEnd() * voxel::kBlockSide - first;
  if (m_words == 0 || count <= 0) return;

  const auto size = static_cast<std::size_t>(m_words) * kBlockColumns;
  if (m_starts.size() < size) m_starts.resize(size);
  for (std::int32_t w = 0; w < m_words; ++w)
    std::copy_n(block.freePlane() + w * kBlockColumns + first, count,
                m_starts.data() + w * kBlockColumns + first);
  // After a step, a bit says that `length` voxels from there on are free; doubling gets there soon.
  for (std::int32_t length = 1; length < m_minRun;)
  {
    const std::int32_t step = std::min(length, m_minRun - length);
    andShifted(m_starts.data() + first, count, m_words, step);
    length += step;
  }
}

std::uint32_t FreeSpanFinder::columnsWithSpan(std::int32_t y) const
{
  return columnsWithBits(m_starts.data(), m_words, y);
}

std::optional<std::int32_t> occupiedTopBelow(const voxel::ColumnBlock& block, std::int32_t column,
                                             std::int32_t z)
{
  const std::uint64_t* plane = block.occupiedPlane() + column;
  const std::int32_t bits = std::min(z - block.zMin(), 64 * block.words());
  for (std::int32_t w = (bits + 63) / 64 - 1; w >= 0; --w)
  {
    const std::int32_t inWord = std::min(bits - 64 * w, 64);
    const std::uint64_t word = plane[w * kBlockColumns] & (~std::uint64_t{0} >> (64 - inWord));
    if (word) return block.zMin() + 64 * w + 64 - __builtin_clzll(word);
  }
  return std::nullopt;
}

std::optional<std::int32_t> occupiedBottomWithin(const voxel::ColumnBlock& block,
                                                 std::int32_t column, std::int32_t begin,
                                                 std::int32_t end)
{
  const std::uint64_t* plane = block.occupiedPlane() + column;
  const std::int32_t first = std::max(begin - block.zMin(), 0);
  const std::int32_t last = std::min(end - block.zMin(), 64 * block.words());
  for (std::int32_t w = first / 64; 64 * w < last; ++w)
  {
    std::uint64_t word = plane[w * kBlockColumns];
    if (w == first / 64) word &= ~std::uint64_t{0} << (first % 64);
    if (!word) continue;
    const std::int32_t bit = 64 * w + __builtin_ctzll(word);
    return bit < last ? std::optional(block.zMin() + bit) : std::nullopt;
  }
  return std::nullopt;
}

std::uint32_t columnsWithOccupied(const voxel::ColumnBlock& block, std::int32_t y)
{
  return columnsWithBits(block.occupiedPlane(), block.words(), y);
}

void appendOccupiedRuns(const voxel::ColumnBlock& block, const voxel::ColumnMask& columns,
                        std::vector<OccupiedRun>& runs)
{
  if (block.words() == 0) return;
  forEachColumn(columns, [&](std::int32_t x, std::int32_t y)
                { appendRunsOf(block, y * voxel::kBlockSide + x, runs); });
}

}  // namespace mrpt_mapconv::freespace
