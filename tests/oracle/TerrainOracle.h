#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace mrpt_mapconv::oracle
{
/** Key of a cell as (y, x), so that maps of them are sorted row by row. */
using TerrainKey = std::pair<int, int>;
/** Something of each known cell: the number of its plane, say, −1 where it has none. */
using TerrainLabels = std::map<TerrainKey, int>;

/** The planes of a map's cells, asked for cell by cell. */
TerrainLabels planesOfCells(const terrain::TerrainMap& map);

/** The 4-connected parts of equal labels, numbered by their first cells; cells with label −1 keep
 * it. */
TerrainLabels connectedParts(const TerrainLabels& labels);

/** What should be the planes, if cells with equal labels lie on one plane: connected parts of at
 * least so many cells, not all of them on one line. */
TerrainLabels truePlanes(const TerrainLabels& labels, std::size_t minCells);

/** A leaf by its definition. */
struct TerrainSquare
{
  int x = 0, y = 0, side = 1, plane = -1;
  bool operator==(const TerrainSquare& o) const
  {
    return x == o.x && y == o.y && side == o.side && plane == o.plane;
  }
};

/** The leaves of cells by their definition: aligned squares of side 2^k that lie wholly in one
 * plane and whose parents do not, by Morton code (signed keys, south before north). */
std::vector<TerrainSquare> leavesOf(const TerrainLabels& planes);

}  // namespace mrpt_mapconv::oracle
