#include "PlaneGrowth.h"

namespace mrpt_mapconv::terrain
{
bool PlaneGrowth::flood(const CellRef& seed, const Plane& plane)
{
  const auto open = [&](const Tile& tile, std::int32_t iy)
  {
    const auto y = static_cast<std::size_t>(iy);
    return nearPlane(plane, m_search.tolerance, tile, iy, tile.known[y] & ~tile.assigned[y]);
  };
  return m_flood.from(seed, open) >= m_search.minCells;
}

/** Grows a plane by flood fill, refits it once and grows it once more. */
bool PlaneGrowth::growFrom(const CellRef& seed, PlaneSet& planes)
{
  const auto found = m_seedPlane.find(seed);
  if (!found || !flood(seed, *found)) return false;
  PlaneMoments moments = m_flood.moments(seed);
  if (!moments.spans()) return false;
  const Plane fitted = moments.fit();
  if (!isAllowed(fitted, m_search) || !flood(seed, fitted)) return false;
  moments = m_flood.moments(seed);
  if (!moments.spans() || !isAllowed(moments.fit(), m_search)) return false;
  const std::int32_t id = planes.add(moments);
  for (const Flood::Part& part : m_flood.parts())
  {
    planes.at(id).tiles.take(*part.tile);
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      forEachBit(part.reached[static_cast<std::size_t>(iy)],
                 [&](std::int32_t ix) { part.tile->assign(Tile::indexOf(ix, iy), id); });
  }
  return true;
}

void PlaneGrowth::grow(const std::vector<TileCells>& seeds, PlaneSet& planes, int)
{
  for (auto begin = seeds.begin(); begin != seeds.end();)
  {
    auto end = begin;
    while (end != seeds.end() && end->tile->ty == begin->tile->ty) ++end;
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      for (auto cells = begin; cells != end; ++cells)
      {
        Tile& tile = *cells->tile;
        const auto y = static_cast<std::size_t>(iy);
        RowBits left = cells->bits[y] & tile.known[y];
        while ((left &= ~tile.assigned[y]) != 0)
        {
          const std::int32_t ix = __builtin_ctz(left);
          left &= left - 1;
          growFrom({&tile, ix, iy}, planes);
        }
      }
    begin = end;
  }
}

}  // namespace mrpt_mapconv::terrain
