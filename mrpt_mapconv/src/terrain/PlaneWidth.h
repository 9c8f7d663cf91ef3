#pragma once

#include "Tile.h"

namespace mrpt_mapconv::terrain
{
/** So much of a width or a square is enough: noise leaves holes and ragged edges. */
constexpr double kNearlyFilled = 0.75;

/** Whether a square of cells with the corner at a cell of a tile is nearly filled, to three
 * quarters: noise leaves holes. \param side at most kTileSide
 * \param rowOf(tile, iy) gives the cells of a row that count */
template <class RowOf>
bool isFilledSquare(const Tile& tile, std::int32_t ix, std::int32_t iy, std::int32_t side,
                    const RowOf& rowOf)
{
  const std::uint64_t wanted = (std::uint64_t{1} << side) - 1;
  std::int32_t cells = 0;
  for (std::int32_t y = iy; y < iy + side; ++y)
  {
    const Tile* here = tile.neighbour(0, y >> kTileBits);
    const Tile* east = tile.neighbour(1, y >> kTileBits);
    const std::uint64_t row = (here ? rowOf(*here, y & kTileMask) : 0) |
                              static_cast<std::uint64_t>(east ? rowOf(*east, y & kTileMask) : 0)
                                  << kTileSide;
    const std::uint64_t part = row >> ix & wanted;
    cells += countOf(static_cast<RowBits>(part)) + countOf(static_cast<RowBits>(part >> kTileSide));
  }
  return cells >= kNearlyFilled * side * side;
}

/** Whether any such square with its corner in a tile is. */
template <class RowOf>
bool hasFilledSquare(const Tile& tile, std::int32_t side, const RowOf& rowOf)
{
  for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    for (RowBits row = rowOf(tile, iy); row; row &= row - 1)
      if (isFilledSquare(tile, lowestOf(row), iy, side, rowOf)) return true;
  return false;
}

}  // namespace mrpt_mapconv::terrain
