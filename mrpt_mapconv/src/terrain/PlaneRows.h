#pragma once

#include "Tile.h"

// Rows of a tile as bits: which cells have a certain plane, and where planes meet.

namespace mrpt_mapconv::terrain
{
/** The cells of a row that belong to a plane. */
RowBits rowOfPlane(const Tile& tile, std::int32_t iy, std::int32_t plane);
/** The cells of a row whose plane differs from that of the cell to the east (or none from a plane);
 * nothing known to the east counts as no plane. */
RowBits differsEast(const Tile& tile, std::int32_t iy);
/** The same to the north. */
RowBits differsNorth(const Tile& tile, std::int32_t iy);
/** The cells that have another plane, or none where they have one, beside them. */
TileBits borderOf(const Tile& tile);

}  // namespace mrpt_mapconv::terrain
