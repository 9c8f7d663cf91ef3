#include <mrpt_mapconv/voxel/ColumnBlock.h>

#include <algorithm>
#include <array>

namespace mrpt_mapconv::voxel
{
namespace
{
/** Rounds down to a multiple of 32, so that an octree node of up to 32 voxels lies in one word. */
std::int32_t floorTo32(std::int32_t z) { return z & ~31; }

/** `count` set bits (1 … 64) from bit `first` on. */
std::uint64_t bits(std::int32_t first, std::int32_t count)
{
  return (~std::uint64_t{0} >> (64 - count)) << first;
}
}  // namespace

void ColumnBlock::start(BlockKey key, const ColumnMask& wanted)
{
  m_key = key;
  m_wanted = wanted;
  m_rowBegin = kBlockSide;
  m_rowEnd = 0;
  for (std::int32_t row = 0; row < kBlockSide; ++row)
    if (wanted[static_cast<std::size_t>(row)])
    {
      m_rowBegin = std::min(m_rowBegin, row);
      m_rowEnd = row + 1;
    }
  m_zMin = 0;
  m_words = 0;
}

void ColumnBlock::setHeight(std::int32_t zBegin, std::int32_t zEnd)
{
  m_zMin = floorTo32(zBegin);
  m_words = 0;
  growTo((zEnd - m_zMin + 63) / 64);
}

/** Adds words in which nothing is known, up to `words` a column. */
void ColumnBlock::growTo(std::int32_t words)
{
  const std::int32_t first = m_words;
  m_words = words;
  const auto size = static_cast<std::size_t>(m_words) * kBlockColumns;
  if (m_free.size() < size)
  {
    m_free.resize(size);
    m_occupied.resize(size);
  }
  if (m_rowBegin >= m_rowEnd) return;
  for (std::int32_t w = first; w < m_words; ++w)
    for (auto* plane : {&m_free, &m_occupied})
      std::fill_n(plane->begin() + w * kBlockColumns + m_rowBegin * kBlockSide,
                  (m_rowEnd - m_rowBegin) * kBlockSide, 0);
}

void ColumnBlock::markSlab(std::int32_t zBegin, std::int32_t zEnd, bool occupied)
{
  auto& plane = occupied ? m_occupied : m_free;
  for (std::int32_t z = zBegin - m_zMin; z < zEnd - m_zMin;)
  {
    const std::int32_t count = std::min(64 - (z & 63), zEnd - m_zMin - z);
    const std::uint64_t voxels = bits(z & 63, count);
    std::uint64_t* word = plane.data() + static_cast<std::size_t>(z >> 6) * kBlockColumns;
    for (std::int32_t c = 0; c < kBlockColumns; ++c) word[c] |= voxels;
    z += count;
  }
}

void ColumnBlock::freeUnknownAboveOccupied(std::int32_t zLast)
{
  const std::int32_t height = zLast + 1 - m_zMin;
  if (m_words == 0 || height <= 0) return;
  growTo(std::max(m_words, (height + 63) / 64));
  std::array<std::uint64_t, kBlockColumns> above{};  // all bits, once a voxel below is occupied
  for (std::int32_t w = 0; 64 * w < height; ++w)
  {
    const std::uint64_t low = bits(0, std::min(64, height - 64 * w));
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(w) * kBlockColumns;
    for (std::int32_t c = m_rowBegin * kBlockSide; c < m_rowEnd * kBlockSide; ++c)
    {
      const std::uint64_t occupied = m_occupied[static_cast<std::size_t>(at + c)];
      auto& fromHere = above[static_cast<std::size_t>(c)];
      fromHere |= occupied | (~occupied + 1);  // from the lowest occupied voxel on; or nothing
      m_free[static_cast<std::size_t>(at + c)] |= fromHere & ~occupied & low;
      fromHere = ~((fromHere >> 63) - 1);
    }
  }
}

}  // namespace mrpt_mapconv::voxel
