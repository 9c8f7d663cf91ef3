#pragma once

#include <mrpt_mapconv/voxel/ColumnSet.h>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace mrpt_mapconv::freespace
{
/** What is known to be occupied in an open column near its floor, in voxels from there. */
struct OpenColumn
{
  std::uint16_t column;         //!< 32·y + x in its block
  std::uint16_t under = kNone;  //!< down to the top face of the highest one under the floor
  std::uint16_t above = kNone;  //!< up to the bottom face of the lowest one above it, if near
  static constexpr std::uint16_t kNone = 0xFFFF;  //!< farther away than anything

  bool isEmpty() const { return under == kNone && above == kNone; }
  bool operator==(const OpenColumn& o) const
  {
    return column == o.column && under == o.under && above == o.above;
  }
};

/** The open columns in which something is. They are few, so no layer holds them. */
class OpenColumns
{
 public:
  /** Nothing if there is nothing in column (kx, ky), or it is not open. */
  std::optional<OpenColumn> at(std::int32_t kx, std::int32_t ky) const;
  std::optional<OpenColumn> at(voxel::BlockKey block, std::int32_t column) const;

  /** Forgets some columns of a block and keeps what was found there.
   * \param found of these columns, in their order */
  void replace(voxel::BlockKey block, const voxel::ColumnMask& columns,
               const std::vector<OpenColumn>& found);

 private:
  using Columns = std::vector<OpenColumn>;  // in their order
  std::unordered_map<voxel::BlockKey, Columns, voxel::ColumnSet::BlockKeyHash> m_blocks;
};

}  // namespace mrpt_mapconv::freespace
