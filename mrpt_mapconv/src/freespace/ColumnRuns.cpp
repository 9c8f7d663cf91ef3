#include "ColumnRuns.h"

#include <algorithm>

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

FreeSpan FreeSpanFinder::span(std::int32_t column) const
{
  const std::uint64_t* words = m_starts.data() + column;
  std::int32_t first = 0, last = m_words - 1;
  while (first < m_words && !words[first * kBlockColumns]) ++first;
  if (first == m_words) return {};
  while (!words[last * kBlockColumns]) --last;
  const std::int32_t lowest = 64 * first + __builtin_ctzll(words[first * kBlockColumns]);
  const std::int32_t highest = 64 * last + 63 - __builtin_clzll(words[last * kBlockColumns]);
  return {m_zMin + lowest, m_zMin + highest + m_minRun};
}

bool isOccupied(const voxel::ColumnBlock& block, std::int32_t column, std::int32_t z)
{
  const std::int32_t bit = z - block.zMin();
  if (bit < 0 || bit >= 64 * block.words()) return false;
  return block.occupiedPlane()[column + bit / 64 * kBlockColumns] >> (bit % 64) & 1U;
}

bool hasOccupied(const voxel::ColumnBlock& block, std::int32_t column)
{
  for (std::int32_t w = 0; w < block.words(); ++w)
    if (block.occupiedPlane()[column + w * kBlockColumns]) return true;
  return false;
}

void appendOccupiedRuns(const voxel::ColumnBlock& block, std::int32_t column,
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

}  // namespace mrpt_mapconv::freespace
