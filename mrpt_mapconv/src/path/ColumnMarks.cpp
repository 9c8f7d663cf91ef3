#include "ColumnMarks.h"

#include <algorithm>

namespace mrpt_mapconv::path
{
using voxel::kBlockSide;

ColumnMarks::ColumnMarks(const voxel::KeyRect& rect)
    : m_rect(rect),
      m_blocks{blockOf(rect.xMin), blockOf(rect.yMin), blockOf(rect.xMax), blockOf(rect.yMax)}
{
  const auto across = static_cast<std::size_t>(m_blocks.xMax - m_blocks.xMin + 1);
  const auto rows = static_cast<std::size_t>(m_blocks.yMax - m_blocks.yMin + 1) * kBlockSide;
  m_words.resize(across * rows);
}

void ColumnMarks::mark(std::int32_t ky, std::int32_t kxBegin, std::int32_t kxEnd)
{
  if (ky < m_rect.yMin || ky > m_rect.yMax) return;
  const std::int32_t first = std::max(kxBegin, m_rect.xMin);
  const std::int32_t last = std::min(kxEnd - 1, m_rect.xMax);
  for (std::int32_t x = blockOf(first); x <= blockOf(last) && first <= last; ++x)
  {
    const std::int32_t begin = std::max(first - x * kBlockSide, 0);
    const std::int32_t end = std::min(last + 1 - x * kBlockSide, kBlockSide);
    m_words[wordOf(x, ky)] |= (voxel::kFullRow >> (kBlockSide - (end - begin))) << begin;
  }
}

voxel::ColumnMask ColumnMarks::mask(voxel::BlockKey block) const
{
  voxel::ColumnMask mask{};
  for (std::int32_t y = 0; y < kBlockSide; ++y)
    mask[static_cast<std::size_t>(y)] = m_words[wordOf(block.x, block.y * kBlockSide + y)];
  return mask;
}

std::size_t ColumnMarks::wordOf(std::int32_t blockX, std::int32_t ky) const
{
  const auto across = static_cast<std::size_t>(m_blocks.xMax - m_blocks.xMin + 1);
  return static_cast<std::size_t>(ky - m_blocks.yMin * kBlockSide) * across +
         static_cast<std::size_t>(blockX - m_blocks.xMin);
}

}  // namespace mrpt_mapconv::path
