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
};
PlaneMeetings meetingsOf(const Tile& tile);

/** The known cells of a tile that have no plane beside one that has. */
TileBits freeBesidePlanes(const Tile& tile);

}  // namespace mrpt_mapconv::terrain
