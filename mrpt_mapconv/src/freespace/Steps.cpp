#include "Steps.h"

#include <array>

#include "ColumnMasks.h"

namespace mrpt_mapconv::freespace
{
using voxel::kBlockSide;

namespace
{
constexpr std::int32_t kNone = FloorTile::kNoFloor;

/** One number for each column of a block's row; loops over all of them become vectors. */
using RowKeys = std::array<std::int32_t, kBlockSide>;

/** Supports of a row, lowered by some units; kNone, below which nothing is, without support. */
RowKeys lowered(const std::int32_t* supports, std::int32_t by)
{
  RowKeys out;
  for (std::int32_t x = 0; x < kBlockSide; ++x)
  {
    const std::int32_t has = -static_cast<std::int32_t>(supports[x] != kNone);
    out[static_cast<std::size_t>(x)] = supports[x] - (by & has);
  }
  return out;
}

/** Calls visit(dx, dy) for the 8 neighbours of a cell. */
template <class Visit>
void forEachNeighbour(const Visit& visit)
{
  for (std::int32_t dy = -1; dy <= 1; ++dy)
    for (std::int32_t dx = -1; dx <= 1; ++dx)
      if (dx != 0 || dy != 0) visit(dx, dy);
}

std::uint32_t rowOf(const RowKeys& found)
{
  return rowWhere([&](std::int32_t x) { return found[static_cast<std::size_t>(x)] != 0; });
}
}  // namespace

voxel::ColumnMask besideStep(const FloorTile& supports, const voxel::ColumnMask& columns,
                             std::int32_t maxStep)
{
  voxel::ColumnMask out{};
  const auto findRow = [&](std::int32_t y, std::uint32_t row)
  {
    const std::int32_t* own = supports.at(0, y);
    const RowKeys lowest = lowered(own, maxStep);
    RowKeys found{};
    forEachNeighbour(
        [&](std::int32_t dx, std::int32_t dy)
        {
          const std::int32_t* other = supports.at(dx, y + dy);
          for (std::size_t x = 0; x < found.size(); ++x)
            found[x] |=
                (other[x] > own[x] + maxStep) | ((other[x] < lowest[x]) & (other[x] != kNone));
        });
    out[static_cast<std::size_t>(y)] = row & rowOf(found);
  };
  forEachRow(columns, findRow);
  return out;
}

voxel::ColumnMask mayBeDropEdge(const FloorTile& supports, const FloorTile& floors,
                                const voxel::ColumnMask& columns, std::int32_t most)
{
  voxel::ColumnMask out{};
  const auto findRow = [&](std::int32_t y, std::uint32_t row)
  {
    const RowKeys lowest = lowered(supports.at(0, y), most);
    RowKeys found{};
    forEachNeighbour(
        [&](std::int32_t dx, std::int32_t dy)
        {
          const std::int32_t *support = supports.at(dx, y + dy), *floor = floors.at(dx, y + dy);
          for (std::size_t x = 0; x < found.size(); ++x)
            found[x] |= (floor[x] != kNone) & ((support[x] == kNone) | (floor[x] < lowest[x]));
        });
    out[static_cast<std::size_t>(y)] = row & rowOf(found);
  };
  forEachRow(columns, findRow);
  return out;
}

}  // namespace mrpt_mapconv::freespace
