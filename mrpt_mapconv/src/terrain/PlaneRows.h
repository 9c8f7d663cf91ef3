#pragma once

#include "Tile.h"

// Rows of a tile as bits: which cells have a certain plane, and where planes meet.

namespace mrpt_mapconv::terrain
{
/** The cells of a row that belong to a plane. */
RowBits rowOfPlane(const Tile& tile, std::int32_t iy, std::int32_t plane);
/** The cells of a row whose plane differs from that of the cell to the east (or none from a plane);
 * what is not known there counts as no plane. */
RowBits differsEast(const Tile& tile, std::int32_t iy);
/** The same to the north. */
RowBits differsNorth(const Tile& tile, std::int32_t iy);

/** Cells of a tile where two planes meet. */
struct PlaneMeetings
{
  TileBits east{}, north{};  //!< another plane lies there
  TileBits any{};            //!< on any of the four sides

  bool empty = true;

  void keepOnly(const TileBits& cells);
};
PlaneMeetings meetingsOf(const Tile& tile);

/** Those bits of a tile that are set, and the ones beside them on four sides, also of the tiles
 * around. \param bits of a tile */
template <class BitsOf>
TileBits besideBits(const Tile& tile, const BitsOf& bits)
{
  TileBits out{};
  const auto rowOf = [&](std::int32_t dx, std::int32_t iy) -> RowBits
  {
    const Tile* there = tile.neighbour(dx, iy >> kTileBits);
    return there ? bits(*there)[static_cast<std::size_t>(iy & kTileMask)] : 0;
  };
  for (std::int32_t iy = 0; iy < kTileSide; ++iy)
  {
    const RowBits row = rowOf(0, iy);
    out[static_cast<std::size_t>(iy)] = row | row << 1 | row >> 1 | rowOf(0, iy - 1) |
                                        rowOf(0, iy + 1) | rowOf(1, iy) << kTileMask |
                                        rowOf(-1, iy) >> kTileMask;
  }
  return out;
}

/** The known cells of a tile that have no plane beside one that has. */
TileBits freeBesidePlanes(const Tile& tile);

}  // namespace mrpt_mapconv::terrain
