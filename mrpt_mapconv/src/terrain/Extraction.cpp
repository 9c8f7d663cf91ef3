#include "Extraction.h"

#include <utility>

namespace mrpt_mapconv::terrain
{
namespace
{
// Planes that are right are settled after one or two; of noise some cells could go to and fro for
// ever.
constexpr int kMostRounds = 2, kMostSweeps = 8;

/** These cells and their 8 neighbours, of which some may have found no plane before. */
std::vector<TileCells> widened(const std::vector<TileCells>& cells)
{
  std::map<std::pair<std::int32_t, std::int32_t>, TileCells> wide;
  const auto add = [&wide](Tile* tile, std::int32_t iy, RowBits bits)
  {
    if (!tile || !bits) return;
    TileCells& part = wide[{tile->ty, tile->tx}];
    part.tile = tile;
    part.bits[static_cast<std::size_t>(iy)] |= bits;
  };
  for (const TileCells& part : cells)
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    {
      const RowBits row = part.bits[static_cast<std::size_t>(iy)];
      if (!row) continue;
      for (std::int32_t y = iy - 1; y <= iy + 1; ++y)
      {
        const std::int32_t north = y >> kTileBits, inTile = y & kTileMask;
        add(part.tile->neighbour(0, north), inTile, row | row << 1 | row >> 1);
        add(part.tile->neighbour(-1, north), inTile, row << kTileMask);
        add(part.tile->neighbour(1, north), inTile, row >> kTileMask);
      }
    }
  std::vector<TileCells> all;
  all.reserve(wide.size());
  for (const auto& entry : wide) all.push_back(entry.second);
  return all;
}
}  // namespace

void Extraction::settleBorders(int threads)
{
  for (int sweep = 0; sweep < kMostSweeps; ++sweep)
  {
    const auto where = m_borders.takeUnsettled(threads);
    const bool merged = m_borders.merge(where);
    const bool moved = m_borders.relax(where, threads);
    refit();
    if (!merged && !moved) return;
  }
}

void Extraction::follow(OpenCells open, int threads)
{
  refit();
  if (!open.areAllCells)
  {
    m_borders.absorb(open.all);
    refit();
    open.seeds = widened(open.seeds);
  }
  for (int round = 0; round < kMostRounds; ++round)
  {
    m_growth.grow(open.seeds, m_planes, threads);
    settleBorders(threads);
    open.seeds = m_borders.splitAndDissolve();
    refit();
    if (open.seeds.empty()) return;
    m_borders.absorb(open.seeds);
    refit();
  }
  m_borders.takeUnsettled(threads);  // what two planes pull at both is left where it is
}

}  // namespace mrpt_mapconv::terrain
