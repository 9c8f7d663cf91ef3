#include "PlaneRows.h"

#include "../grid/Wide.h"

namespace mrpt_mapconv::terrain
{
namespace
{
constexpr std::array<std::uint32_t, kTileSide> bitsOfColumns()
{
  std::array<std::uint32_t, kTileSide> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = std::uint32_t{1} << i;
  return bits;
}
constexpr auto kColumns = bitsOfColumns();

MRPT_MAPCONV_WIDE
RowBits equalTo(const std::int32_t* __restrict row, std::int32_t value)
{
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < kTileSide; ++i) bits |= row[i] == value ? kColumns[i] : 0;
  return bits;
}

MRPT_MAPCONV_WIDE
RowBits different(const std::int32_t* a, const std::int32_t* b)
{
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < kTileSide; ++i) bits |= a[i] != b[i] ? kColumns[i] : 0;
  return bits;
}

const std::int32_t* rowOf(const Tile& tile, std::int32_t iy)
{
  return tile.plane.data() + static_cast<std::size_t>(iy) * kTileSide;
}

/** Row iy, which may be that of a tile to the north or south. */
RowBits differsFromRow(const Tile& tile, std::int32_t iy, std::int32_t other)
{
  const Tile* there = tile.neighbour(0, other >> kTileBits);
  return there ? different(rowOf(tile, iy), rowOf(*there, other & kTileMask))
               : tile.assigned[static_cast<std::size_t>(iy)];
}

/** Assigned cells of a row, which may be that of a tile to the north or south. */
RowBits assignedRow(const Tile& tile, std::int32_t iy)
{
  const Tile* there = tile.neighbour(0, iy >> kTileBits);
  return there ? there->assigned[static_cast<std::size_t>(iy & kTileMask)] : 0;
}

std::int32_t planeOf(const Tile* tile, std::int32_t ix, std::int32_t iy)
{
  return tile ? tile->plane[Tile::indexOf(ix, iy)] : kNoPlane;
}
}  // namespace

RowBits rowOfPlane(const Tile& tile, std::int32_t iy, std::int32_t plane)
{
  const RowBits assigned = tile.assigned[static_cast<std::size_t>(iy)];
  return assigned ? assigned & equalTo(rowOf(tile, iy), plane) : 0;
}

RowBits differsEast(const Tile& tile, std::int32_t iy)
{
  const std::int32_t* row = rowOf(tile, iy);
  std::int32_t next[kTileSide];
  for (std::size_t i = 0; i + 1 < kTileSide; ++i) next[i] = row[i + 1];
  next[kTileMask] = planeOf(tile.neighbour(1, 0), 0, iy);
  return different(row, next);
}

RowBits differsNorth(const Tile& tile, std::int32_t iy) { return differsFromRow(tile, iy, iy + 1); }

PlaneMeetings meetingsOf(const Tile& tile)
{
  PlaneMeetings meet;
  const Tile *east = tile.neighbour(1, 0), *west = tile.neighbour(-1, 0);
  RowBits all = 0;
  for (std::int32_t iy = 0; iy < kTileSide; ++iy)
  {
    const auto y = static_cast<std::size_t>(iy);
    const RowBits assigned = tile.assigned[y];
    if (!assigned) continue;
    const RowBits beyond = east ? east->assigned[y] << kTileMask : 0;
    meet.east[y] = differsEast(tile, iy) & assigned & (assigned >> 1 | beyond);
    meet.north[y] = differsNorth(tile, iy) & assigned & assignedRow(tile, iy + 1);
    meet.any[y] |= meet.east[y] | meet.east[y] << 1 | meet.north[y];
    const std::int32_t beside = planeOf(west, kTileMask, iy);
    if ((assigned & 1u) && beside != kNoPlane && beside != tile.plane[Tile::indexOf(0, iy)])
      meet.any[y] |= 1;
    if (iy < kTileMask) meet.any[y + 1] |= meet.north[y];
    all |= meet.any[y];
  }
  const RowBits south = differsFromRow(tile, 0, -1) & tile.assigned[0] & assignedRow(tile, -1);
  meet.any[0] |= south;
  meet.empty = (all | south) == 0;
  return meet;
}

TileBits freeBesidePlanes(const Tile& tile)
{
  TileBits cells = besideBits(tile, [](const Tile& t) -> const TileBits& { return t.assigned; });
  for (std::size_t y = 0; y < kTileSide; ++y) cells[y] &= tile.known[y] & ~tile.assigned[y];
  return cells;
}

void PlaneMeetings::keepOnly(const TileBits& cells)
{
  empty = true;
  for (std::size_t y = 0; y < kTileSide; ++y)
  {
    east[y] &= cells[y];
    north[y] &= cells[y];
    any[y] &= cells[y];
    empty &= any[y] == 0;
  }
}

}  // namespace mrpt_mapconv::terrain
