#include "SmallFlood.h"

#include <cmath>

namespace mrpt_mapconv::terrain
{
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
