#pragma once

#include <mrpt_mapconv/voxel/ColumnBlock.h>

#include <cstdint>
#include <vector>

namespace mrpt_mapconv::freespace
{
/** The kept free ranges of one column, as far as the layers need them: z keys of the lowest kept
 * range's bottom face and of the highest kept range's top face. */
struct FreeSpan
{
  std::int32_t floor = 0, ceiling = 0;
  bool valid() const { return ceiling > floor; }
};

/** Finds the kept free ranges (R_maxZ) of all columns of a block. */
class FreeSpanFinder
{
 public:
  /** \param minRun voxels that a free range needs to be kept */
  explicit FreeSpanFinder(std::int32_t minRun) : m_minRun(minRun) {}
  /** Takes up a block; spans are then asked for column by column. */
  void start(const voxel::ColumnBlock& block);
  /** \param column 32·y + x */
  FreeSpan span(std::int32_t column) const;

 private:
  std::int32_t m_minRun;
  std::int32_t m_zMin = 0, m_words = 0;
  std::vector<std::uint64_t> m_starts;  // bit set: a range of minRun free voxels begins here
};

/** Whether a voxel of a column of the block is occupied; one outside the block is not. */
bool isOccupied(const voxel::ColumnBlock& block, std::int32_t column, std::int32_t z);
/** Whether any voxel of it is. */
bool hasOccupied(const voxel::ColumnBlock& block, std::int32_t column);

/** A run of occupied voxels, z keys [begin, end), in column 32·y + x of a block. */
struct OccupiedRun
{
  std::int32_t column, begin, end;
};

/** Appends the runs of occupied voxels of one column of the block, from the lowest up. */
void appendOccupiedRuns(const voxel::ColumnBlock& block, std::int32_t column,
                        std::vector<OccupiedRun>& runs);

}  // namespace mrpt_mapconv::freespace
