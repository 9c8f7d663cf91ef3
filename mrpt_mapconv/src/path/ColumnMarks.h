#pragma once

#include <mrpt_mapconv/voxel/ColumnBlock.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <vector>

namespace mrpt_mapconv::path
{
/** Columns picked from a rectangle, as bits laid out by blocks: many overlapping discs are marked
 * faster than one column at a time. */
class ColumnMarks
{
 public:
  explicit ColumnMarks(const voxel::KeyRect& rect);

  /** Marks the columns [kxBegin, kxEnd) of row ky, as far as they lie in the rectangle. */
  void mark(std::int32_t ky, std::int32_t kxBegin, std::int32_t kxEnd);
  /** The blocks that the rectangle touches. */
  const voxel::KeyRect& blocks() const { return m_blocks; }
  /** The marked columns of one of them. */
  voxel::ColumnMask mask(voxel::BlockKey block) const;

 private:
  std::size_t wordOf(std::int32_t blockX, std::int32_t ky) const;

  voxel::KeyRect m_rect, m_blocks;
  std::vector<std::uint32_t> m_words;  // one per row of a block; rows from the lowest y
};

/** The block that holds a key, on either axis. */
inline std::int32_t blockOf(std::int32_t key) { return key >> 5; }
static_assert(voxel::kBlockSide == 1 << 5);

}  // namespace mrpt_mapconv::path
