#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <vector>

#include "Tile.h"

namespace mrpt_mapconv::terrain
{
/** A plane as those of its cells tell that are not at its border: noise draws the cells at the
 * border of a tread towards what lies below or above it, and the tread's plane with them.
 *
 * \param all the plane, of which cells and extent stay \param cells of it, at least one
 * \param minCells if fewer lie inside, it stays as it is */
TerrainPlane innerPlane(const TerrainPlane& all, const std::vector<CellRef>& cells,
                        std::int64_t minCells, double resolution);

}  // namespace mrpt_mapconv::terrain
