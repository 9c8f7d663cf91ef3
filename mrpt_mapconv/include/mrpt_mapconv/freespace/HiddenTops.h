#pragma once

#include <mrpt_mapconv/voxel/ColumnSet.h>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace mrpt_mapconv::freespace
{
/** What is known to stand in a column under its floor: z key of the top face of the highest
 * occupied voxel there. */
struct HiddenTop
{
  std::int32_t column;  //!< 32·y + x in its block
  std::int32_t top;
};

/** The hidden tops of all open cells that have one. They are few, so no layer holds them. */
class HiddenTops
{
 public:
  /** z key; nothing if nothing is known to be occupied under the floor of column (kx, ky). */
  std::optional<std::int32_t> at(std::int32_t kx, std::int32_t ky) const;
  std::optional<std::int32_t> at(voxel::BlockKey block, std::int32_t column) const;

  /** Forgets those of some columns of a block and keeps what was found there.
   * \param found of these columns, in their order */
  void replace(voxel::BlockKey block, const voxel::ColumnMask& columns,
               const std::vector<HiddenTop>& found);

 private:
  using Tops = std::vector<HiddenTop>;  // in the order of their columns
  std::unordered_map<voxel::BlockKey, Tops, voxel::ColumnSet::BlockKeyHash> m_blocks;
};

}  // namespace mrpt_mapconv::freespace
