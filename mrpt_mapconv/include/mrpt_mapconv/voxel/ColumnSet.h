#pragma once

#include <mrpt_mapconv/grid/GridFrame.h>
#include <mrpt_mapconv/voxel/ColumnBlock.h>

#include <cstddef>
#include <unordered_map>

namespace mrpt_mapconv::voxel
{
/** A set of columns, kept as one mask per block: what a scan has changed, or a whole map. */
class ColumnSet
{
 public:
  struct BlockKeyHash
  {
    std::size_t operator()(const BlockKey& k) const
    {
      return std::hash<std::uint64_t>()(static_cast<std::uint64_t>(static_cast<std::uint32_t>(k.x))
                                            << 32 |
                                        static_cast<std::uint32_t>(k.y));
    }
  };
  using Blocks = std::unordered_map<BlockKey, ColumnMask, BlockKeyHash>;

  /** All columns of a frame. */
  static ColumnSet of(const grid::GridFrame& frame);

  /** Adds the column with keys (kx, ky). */
  void insert(std::int32_t kx, std::int32_t ky);
  /** Adds columns of a block. */
  void insert(const BlockKey& block, const ColumnMask& columns);
  /** Adds all columns of another set. */
  void insert(const ColumnSet& other);
  bool contains(std::int32_t kx, std::int32_t ky) const;
  bool empty() const { return m_blocks.empty(); }
  std::size_t size() const;  //!< number of columns
  void clear() { m_blocks.clear(); }
  const Blocks& blocks() const { return m_blocks; }

  /** Calls visit(kx, ky) for every column, block by block. */
  template <class Visit>
  void forEach(const Visit& visit) const
  {
    for (const auto& [key, mask] : m_blocks)
      for (std::int32_t y = 0; y < kBlockSide; ++y)
        for (std::uint32_t row = mask[static_cast<std::size_t>(y)]; row; row &= row - 1)
          visit(key.x * kBlockSide + __builtin_ctz(row), key.y * kBlockSide + y);
  }

  /** All columns within Chebyshev distance `radius` of one in the set. */
  ColumnSet dilated(std::int32_t radius) const;
  /** The columns that also lie in the frame. */
  ColumnSet clipped(const grid::GridFrame& frame) const;
  /** The smallest frame that holds the set; empty for an empty set. */
  grid::GridFrame bounds(double resolution) const;

 private:
  Blocks m_blocks;
};

/** The columns of one block within Chebyshev distance `radius` of a column in `set`: what
 * ColumnSet::dilated() holds of that block, for who needs it block by block. */
ColumnMask columnsNear(const ColumnSet::Blocks& set, BlockKey block, std::int32_t radius);

}  // namespace mrpt_mapconv::voxel
