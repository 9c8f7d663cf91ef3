#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace mrpt_mapconv::voxel
{
/** Columns are handled in blocks of kBlockSide × kBlockSide, aligned to multiples of kBlockSide. */
constexpr std::int32_t kBlockSide = 32;
constexpr std::int32_t kBlockColumns = kBlockSide * kBlockSide;

/** Block (x, y) holds the columns with keys [32x, 32x+32) × [32y, 32y+32). */
struct BlockKey
{
  std::int32_t x = 0, y = 0;
  bool operator==(const BlockKey& o) const { return x == o.x && y == o.y; }
};

/** Which columns of a block are meant: bit x of word y is column (x, y) of the block. */
using ColumnMask = std::array<std::uint32_t, kBlockSide>;
constexpr std::uint32_t kFullRow = 0xFFFFFFFFu;

/** The voxels of one block of columns as bit planes: for each column one bit per voxel for "free"
 * and one for "occupied"; neither is unknown.
 *
 * Word w of column c (c = 32·y + x) holds the voxels with z keys zMin() + 64w … + 63, lowest voxel
 * in the lowest bit, and stands at plane[w·1024 + c]: the same word of neighbouring columns lies
 * side by side in memory.
 */
class ColumnBlock
{
 public:
  /** Starts a new block; no voxel is known. `wanted` names the columns that will be looked at; a
   * source may leave the others out. */
  void start(BlockKey key, const ColumnMask& wanted);

  /** Called once by the source before it marks voxels: makes room for the z keys
   * [zBegin, zEnd). */
  void setHeight(std::int32_t zBegin, std::int32_t zEnd);

  /** Marks the cube of `size`³ voxels whose lowest corner is column (x, y) of the block and z key
   * z. `size` is a power of two ≤ 32 and divides x, y and z. */
  template <std::int32_t size>
  void markCube(std::int32_t x, std::int32_t y, std::int32_t z, bool occupied)
  {
    static_assert(size >= 1 && size <= kBlockSide && (size & (size - 1)) == 0);
    const auto above = static_cast<std::uint32_t>(z - m_zMin);
    const std::uint64_t voxels = ((std::uint64_t{1} << size) - 1) << (above & 63u);
    std::uint64_t* column =
        (occupied ? m_occupied : m_free).data() + (above >> 6) * kBlockColumns + columnIndex(x, y);
    for (std::int32_t row = 0; row < size; ++row, column += kBlockSide)
      for (std::int32_t i = 0; i < size; ++i) column[i] |= voxels;
  }

  /** Marks the voxels [zBegin, zEnd) of all columns of the block. */
  void markSlab(std::int32_t zBegin, std::int32_t zEnd, bool occupied);

  /** Marks up to 2×2×2 finest voxels at once; bit i of `free` and `occupied` is the voxel at
   * (x + (i&1), y + (i>>1&1), z + (i>>2)), as an octree numbers its children. x, y, z are even. */
  void markOctet(std::int32_t x, std::int32_t y, std::int32_t z, unsigned free, unsigned occupied)
  {
    const auto above = static_cast<std::uint32_t>(z - m_zMin);
    const unsigned shift = above & 63u;
    const std::size_t at = (above >> 6) * kBlockColumns + columnIndex(x, y);
    if (free) orPairs(m_free.data() + at, free, shift);
    if (occupied) orPairs(m_occupied.data() + at, occupied, shift);
  }

  /** Marks up to 32 voxels of column (x, y), from z key z on, which is a multiple of 16; the lowest
   * is the lowest bit. They must not reach across a multiple of 32. */
  void markColumn(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t free,
                  std::uint32_t occupied)
  {
    const auto above = static_cast<std::uint32_t>(z - m_zMin);
    const std::size_t at = (above >> 6) * kBlockColumns + columnIndex(x, y);
    m_free[at] |= static_cast<std::uint64_t>(free) << (above & 63u);
    m_occupied[at] |= static_cast<std::uint64_t>(occupied) << (above & 63u);
  }

  /** Marks as free, in each column with an occupied voxel, the unknown voxels from its lowest
   * occupied one up to z key zLast. Called after the source has marked what it knows. */
  void freeUnknownAboveOccupied(std::int32_t zLast);

  BlockKey key() const { return m_key; }
  const ColumnMask& wanted() const { return m_wanted; }
  /** Rows [rowBegin(), rowEnd()) hold all wanted columns; what the planes hold elsewhere is not
   * defined. */
  std::int32_t rowBegin() const { return m_rowBegin; }
  std::int32_t rowEnd() const { return m_rowEnd; }
  std::int32_t zMin() const { return m_zMin; }    //!< z key of bit 0 of word 0; a multiple of 32
  std::int32_t words() const { return m_words; }  //!< words per column; 0: nothing is known here
  const std::uint64_t* freePlane() const { return m_free.data(); }
  const std::uint64_t* occupiedPlane() const { return m_occupied.data(); }

 private:
  static std::size_t columnIndex(std::int32_t x, std::int32_t y)
  {
    return static_cast<std::size_t>(y * kBlockSide + x);
  }
  static void orPairs(std::uint64_t* column, unsigned octet, unsigned shift)
  {
    // bits i and i+4 of an octet are the same column, one voxel apart
    column[0] |= static_cast<std::uint64_t>((octet & 1u) | (octet >> 3 & 2u)) << shift;
    column[1] |= static_cast<std::uint64_t>((octet >> 1 & 1u) | (octet >> 4 & 2u)) << shift;
    column[kBlockSide] |= static_cast<std::uint64_t>((octet >> 2 & 1u) | (octet >> 5 & 2u))
                          << shift;
    column[kBlockSide + 1] |= static_cast<std::uint64_t>((octet >> 3 & 1u) | (octet >> 6 & 2u))
                              << shift;
  }

  void growTo(std::int32_t words);

  BlockKey m_key;
  ColumnMask m_wanted{};
  std::int32_t m_rowBegin = 0, m_rowEnd = 0;
  std::int32_t m_zMin = 0, m_words = 0;
  std::vector<std::uint64_t> m_free, m_occupied;
};

}  // namespace mrpt_mapconv::voxel
