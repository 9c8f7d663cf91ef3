#include "SmallFlood.h"

#include <cmath>

namespace mrpt_mapconv::terrain
{
bool SmallFlood::isAmongFree(const CellRef& seed)
{
  if (std::min(seed.ix, seed.iy) < 1 || std::max(seed.ix, seed.iy) >= kTileMask) return false;
  RowBits free = ~RowBits{0};
  for (std::size_t y = static_cast<std::size_t>(seed.iy) - 1, i = 0; i < 3; ++i, ++y)
    free &= seed.tile->known[y] & ~seed.tile->assigned[y];
  return (free >> (seed.ix - 1) & 7u) == 7u;
}

/** Forgets what was visited, in those rows that may be. */
void SmallFlood::start()
{
  const auto rows = static_cast<std::ptrdiff_t>(m_most) + 1;
  std::fill(m_visited.begin() + kMiddle - rows, m_visited.begin() + kMiddle + rows, 0);
}

/** \return whether it was not visited before */
bool SmallFlood::visit(const Offset& at)
{
  std::uint64_t& row = m_visited[static_cast<std::size_t>(at.y + kMiddle)];
  const std::uint64_t bit = std::uint64_t{1} << (at.x + kMiddle);
  if (row & bit) return false;
  row |= bit;
  return true;
}

bool SmallFlood::mayBePlane(const CellRef& seed, const Plane& plane)
{
  return isLarge(seed,
                 [&](const CellRef& cell)
                 {
                   const double height = cell.tile->height[cell.index()];
                   return std::fabs(height - plane.at(cell.keyX(), cell.keyY())) <=
                          m_search.tolerance;
                 });
}

}  // namespace mrpt_mapconv::terrain
