#include "TerrainMapImpl.h"

#include <mrpt_mapconv/grid/Resolution.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "../grid/Parallel.h"
#include "../grid/Wide.h"
#include "Extraction.h"

namespace mrpt_mapconv::terrain
{
namespace
{
PlaneSearch searchFor(const TerrainParams& params, double resolution)
{
  PlaneSearch search;
  search.tolerance = params.planeTolerance / kHeightUnit;
  search.mostSlope = params.maxPlaneSlope * resolution / kHeightUnit;
  const double window = std::min<double>(kTileSide, std::round(params.planeWindow / resolution));
  search.window = std::max(2, static_cast<std::int32_t>(window));
  search.hypotheses = params.hypotheses;
  search.blockCells = params.blockCells;
  search.minCells = params.minPlaneCells;
  const double width = std::round(params.minPlaneWidth / resolution);
  search.minWidth = static_cast<std::int32_t>(std::clamp<double>(width, 1, kTileSide));
  return search;
}
}  // namespace

TerrainMap::Impl::Impl(double l, const TerrainParams& p) : resolution(l), params(p)
{
  grid::requireResolution(l);
  params.check();
  search = searchFor(params, resolution);
}

namespace
{
/** The tiles of points, and their cells in them. */
struct Places
{
  std::array<std::int32_t, PointModel::kBatch> tx, ty, at;
};
MRPT_MAPCONV_WIDE
void findPlaces(const PointModel::Batch& batch, std::size_t count, Places& out)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    out.tx[i] = batch.kx[i] >> kTileBits;
    out.ty[i] = batch.ky[i] >> kTileBits;
    out.at[i] = (batch.ky[i] & kTileMask) << kTileBits | (batch.kx[i] & kTileMask);
  }
}
}  // namespace

/** Adds points to their cells: first all cells are found, so that they are on their way from memory
 * when their turn comes. */
void TerrainMap::Impl::add(TileCache& cache, const PointModel::Batch& batch, std::size_t count,
                           InsertedPoints& result)
{
  Places places;
  findPlaces(batch, count, places);
  std::array<Tile*, PointModel::kBatch> tileOf;
  for (std::size_t i = 0; i < count; ++i)
  {
    Tile* tile = nullptr;
    if (batch.weight[i] == 0)
      ++result.notFinite;
    else if (window && !window->holds(batch.kx[i], batch.ky[i]))
      ++result.outside;
    else
      tile = &cache.at(places.tx[i], places.ty[i]);
    tileOf[i] = tile;
    if (tile) __builtin_prefetch(&tile->sums[static_cast<std::size_t>(places.at[i])], 1);
  }
  for (std::size_t i = 0; i < count; ++i)
    if (tileOf[i])
      add(*tileOf[i], static_cast<std::size_t>(places.at[i]), batch.z[i],
          static_cast<std::uint32_t>(batch.weight[i]));
}

/** Takes the changed cells of a row into account. */
void TerrainMap::Impl::takeRow(Tile& tile, std::int32_t iy)
{
  const auto y = static_cast<std::size_t>(iy);
  forEachBit(tile.changed[y],
             [&](std::int32_t ix)
             {
               const CellRef cell{&tile, ix, iy};
               CellSums& sums = tile.sums[cell.index()];
               sums.isMarked = 0;
               planes.setHeight(
                   cell, params.heightRule == HeightRule::Fused ? sums.fusedZ() : sums.highestZ(),
                   search.tolerance);
             });
  tile.isStale |= (tile.changed[y] & ~tile.known[y]) != 0;
  tile.known[y] |= tile.changed[y];
}

/** Those cells of a row from which a plane is looked for: not again and again, but when a cell is
 * new, and when its points are twice as many. */
RowBits TerrainMap::Impl::seedsOf(Tile& tile, std::int32_t iy, RowBits open)
{
  constexpr std::uint32_t kMostTried = 0x7FFFFFFFu;  // it has 31 bits
  RowBits seeds = 0;
  forEachBit(open,
             [&](std::int32_t ix)
             {
               CellSums& sums = tile.sums[Tile::indexOf(ix, iy)];
               if (sums.points < 2 * std::uint64_t{sums.triedWith}) return;
               sums.triedWith = std::min(sums.points, kMostTried) & kMostTried;
               seeds |= RowBits{1} << ix;
             });
  return seeds;
}

OpenCells TerrainMap::Impl::takeChanges()
{
  OpenCells open;
  open.areAllCells = allOpen;
  for (Tile* tile : tiles.sorted())
  {
    if (!tile->hasChanged && !allOpen) continue;
    TileCells cellsOfTile{tile, {}}, seeds{tile, {}};
    RowBits anyOpen = 0, anySeed = 0;
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    {
      const auto y = static_cast<std::size_t>(iy);
      if (tile->changed[y]) takeRow(*tile, iy);
      const RowBits row = (allOpen ? tile->known[y] : tile->changed[y]) & ~tile->assigned[y];
      if (!row) continue;
      cellsOfTile.bits[y] = row;
      seeds.bits[y] = allOpen ? row : seedsOf(*tile, iy, row);
      anyOpen |= row;
      anySeed |= seeds.bits[y];
    }
    tile->changed = {};
    tile->hasChanged = false;
    if (anyOpen) open.all.push_back(cellsOfTile);
    if (anySeed) open.seeds.push_back(seeds);
  }
  allOpen = false;
  return open;
}

void TerrainMap::Impl::follow(int threads)
{
  Extraction(search, tiles, planes).follow(takeChanges(), threads);
  tree.follow(tiles, threads);
  listPlanes();
}

void TerrainMap::Impl::forgetPlanes()
{
  planes.clear();
  tree.clear();
  list.clear();
  indices.clear();
  for (Tile* tile : tiles.sorted())
  {
    tile->plane.fill(kNoPlane);
    tile->assigned = {};
    tile->isStale = true;
  }
  allOpen = true;
}

void TerrainMap::Impl::listPlanes()
{
  struct Found
  {
    TilePlane part;
    std::int32_t id;
  };
  std::vector<Found> found(static_cast<std::size_t>(planes.end()), Found{{}, kNoPlane});
  for (const Tile* tile : tiles.sorted())
    for (const TilePlane& part : tile->planes)
    {
      Found& all = found[static_cast<std::size_t>(part.plane)];
      if (all.id == kNoPlane)
      {
        all = {part, part.plane};
        continue;
      }
      if (std::tie(part.yMin, part.firstX) < std::tie(all.part.yMin, all.part.firstX))
        all.part.firstX = part.firstX;
      all.part.xMin = std::min(all.part.xMin, part.xMin);
      all.part.yMin = std::min(all.part.yMin, part.yMin);
      all.part.xMax = std::max(all.part.xMax, part.xMax);
      all.part.yMax = std::max(all.part.yMax, part.yMax);
    }
  indices.assign(found.size(), kNoPlane);
  found.erase(
      std::remove_if(found.begin(), found.end(), [](const Found& f) { return f.id == kNoPlane; }),
      found.end());
  std::sort(found.begin(), found.end(),
            [](const Found& a, const Found& b) {
              return std::tie(a.part.yMin, a.part.firstX) < std::tie(b.part.yMin, b.part.firstX);
            });
  list.clear();
  for (const Found& f : found)
  {
    indices[static_cast<std::size_t>(f.id)] = static_cast<std::int32_t>(list.size());
    const PlaneState& state = planes.at(f.id);
    const PlaneMoments& moments = state.moments;
    TerrainPlane plane;
    plane.cells = moments.cells();
    plane.slopeX = state.plane.slopeX * slopeUnit();
    plane.slopeY = state.plane.slopeY * slopeUnit();
    plane.x = moments.meanX() * resolution;
    plane.y = moments.meanY() * resolution;
    plane.z = kHeightUnit *
              (state.plane.height + state.plane.slopeX * (moments.meanX() - state.plane.originX) +
               state.plane.slopeY * (moments.meanY() - state.plane.originY));
    plane.rms = moments.rms() * kHeightUnit;
    plane.xMin = (f.part.xMin - 0.5) * resolution;
    plane.yMin = (f.part.yMin - 0.5) * resolution;
    plane.xMax = (f.part.xMax + 0.5) * resolution;
    plane.yMax = (f.part.yMax + 0.5) * resolution;
    plane.firstX = f.part.firstX;
    plane.firstY = f.part.yMin;
    list.push_back(plane);
  }
}

CellRef TerrainMap::Impl::knownCell(std::int32_t kx, std::int32_t ky) const
{
  const CellRef cell = tiles.cell(kx, ky);
  return cell && cell.tile->isKnown(cell.ix, cell.iy) ? cell : CellRef{};
}

/** Forgets cells of a tile. */
void TerrainMap::Impl::forget(Tile& tile, const TileBits& outside)
{
  for (std::int32_t iy = 0; iy < kTileSide; ++iy)
  {
    const auto y = static_cast<std::size_t>(iy);
    forEachBit(outside[y] & tile.assigned[y],
               [&](std::int32_t ix) {
                 planes.release({&tile, ix, iy});
               });
    forEachBit(outside[y] & (tile.known[y] | tile.changed[y]),
               [&](std::int32_t ix)
               {
                 tile.sums[Tile::indexOf(ix, iy)] = {};
                 --cells;
               });
    tile.known[y] &= ~outside[y];
    tile.changed[y] &= ~outside[y];
  }
  tile.isStale = tile.hasChanged = true;
}

/** Moves the local window to the robot, by whole cells, and forgets what it leaves. */
void TerrainMap::Impl::moveWindow(double x, double y)
{
  if (params.localWindow == 0) return;
  const auto key = [this](double v)
  { return static_cast<std::int32_t>(std::floor(v / resolution + 0.5)); };
  const auto half = static_cast<std::int32_t>(
      std::min(1e9, std::max(0.0, std::floor(params.localWindow / 2 / resolution))));
  const std::int32_t kx = key(x), ky = key(y);
  const KeyWindow moved{kx - half, ky - half, kx + half, ky + half};
  window = moved;
  const auto columns = [&](std::int32_t from) -> RowBits
  {
    const std::int32_t first = std::max(moved.xMin - from, 0),
                       last = std::min(moved.xMax - from, kTileMask);
    if (first > kTileMask || last < first) return 0;
    return ~RowBits{0} << first & ~RowBits{0} >> (kTileMask - last);
  };
  bool hasForgotten = false;
  for (Tile* tile : std::vector<Tile*>(tiles.sorted()))
  {
    TileBits outside;
    RowBits anyInside = 0, anyOutside = 0;
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    {
      const std::int32_t keyY = tile->keyY(iy);
      const RowBits inside = keyY >= moved.yMin && keyY <= moved.yMax ? columns(tile->keyX(0)) : 0;
      outside[static_cast<std::size_t>(iy)] = ~inside;
      anyInside |= inside;
      anyOutside |= ~inside & (tile->known[static_cast<std::size_t>(iy)] |
                               tile->changed[static_cast<std::size_t>(iy)]);
    }
    if (anyOutside) forget(*tile, outside);
    hasForgotten |= anyOutside != 0;
    if (!anyInside) tiles.remove(*tile);
  }
  if (!hasForgotten) return;
  // until the next update, too, nobody may find what is gone
  tree.follow(tiles, 1);
  listPlanes();
}

}  // namespace mrpt_mapconv::terrain
