#pragma once

#include <utility>
#include <vector>

#include "../mrpt_mapconv/src/terrain/TileMap.h"

namespace mrpt_mapconv::test
{
/** Makes a cell known. \param z [kHeightUnit] */
inline terrain::CellRef putCell(terrain::TileMap& tiles, int x, int y, std::int32_t z)
{
  using namespace terrain;
  Tile& tile = tiles.get(x >> kTileBits, y >> kTileBits);
  const CellRef cell{&tile, x & kTileMask, y & kTileMask};
  tile.known[static_cast<std::size_t>(cell.iy)] |= RowBits{1} << cell.ix;
  tile.height[cell.index()] = z;
  return cell;
}

/** All known cells, tiles row by row. */
inline std::vector<terrain::TileCells> allCells(const terrain::TileMap& tiles)
{
  std::vector<terrain::TileCells> cells;
  for (terrain::Tile* tile : tiles.sorted()) cells.push_back({tile, tile->known});
  return cells;
}

}  // namespace mrpt_mapconv::test
