#pragma once

#include <mrpt_mapconv/voxel/ColumnBlock.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace mrpt_mapconv::freespace
{
/** The kept free ranges of one column, as far as the layers need them: z keys of the lowest kept
 * range's bottom face and of the highest kept range's top face. */
struct FreeSpan
{
  std::int32_t floor, ceiling;
};

/** Finds the kept free ranges (R_maxZ) of all columns of a block. */
class FreeSpanFinder
{
 public:
  /** \param minRun voxels that a free range needs to be kept */
  explicit FreeSpanFinder(std::int32_t minRun) : m_minRun(minRun) {}
  /** Takes up a block; it is then asked for its rows and columns. */
  void start(const voxel::ColumnBlock& block);
  /** The columns of row y with a kept range. */
  std::uint32_t columnsWithSpan(std::int32_t y) const;
  /** \param column 32·y + x, which has one */
  FreeSpan span(std::int32_t column) const
  {
    const std::uint64_t* words = m_starts.data() + column;
    std::int32_t first = 0, last = m_words - 1;
    while (!words[first * voxel::kBlockColumns]) ++first;
    while (!words[last * voxel::kBlockColumns]) --last;
    const std::int32_t lowest = 64 * first + __builtin_ctzll(words[first * voxel::kBlockColumns]);
    const std::int32_t highest =
        64 * last + 63 - __builtin_clzll(words[last * voxel::kBlockColumns]);
    return {m_zMin + lowest, m_zMin + highest + m_minRun};
  }

 private:
  std::int32_t m_minRun;
  std::int32_t m_zMin = 0, m_words = 0;
  std::vector<std::uint64_t> m_starts;  // bit set: a range of minRun free voxels begins here
};

/** Whether a voxel of a column of the block is occupied; one outside the block is not. */
inline bool isOccupied(const voxel::ColumnBlock& block, std::int32_t column, std::int32_t z)
{
  const std::int32_t bit = z - block.zMin();
  if (bit < 0 || bit >= 64 * block.words()) return false;
  return block.occupiedPlane()[column + bit / 64 * voxel::kBlockColumns] >> (bit % 64) & 1U;
}
/** z key of the top face of a column's highest occupied voxel below z. */
std::optional<std::int32_t> occupiedTopBelow(const voxel::ColumnBlock& block, std::int32_t column,
                                             std::int32_t z);
/** z key of the bottom face of a column's lowest occupied voxel in [begin, end). */
std::optional<std::int32_t> occupiedBottomWithin(const voxel::ColumnBlock& block,
                                                 std::int32_t column, std::int32_t begin,
                                                 std::int32_t end);
/** The columns of row y of the block with an occupied voxel. */
std::uint32_t columnsWithOccupied(const voxel::ColumnBlock& block, std::int32_t y);

/** A run of occupied voxels, z keys [begin, end), in column 32·y + x of a block. */
struct OccupiedRun
{
  std::int32_t column, begin, end;
};

/** Appends the runs of occupied voxels of some columns of the block, column by column and from the
 * lowest up. */
void appendOccupiedRuns(const voxel::ColumnBlock& block, const voxel::ColumnMask& columns,
                        std::vector<OccupiedRun>& runs);

}  // namespace mrpt_mapconv::freespace
