#include "SmallFlood.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::terrain
{
/** \return whether it was not visited before */
bool SmallFlood::visit(std::int32_t dx, std::int32_t dy)
{
  std::uint64_t& row = m_visited[static_cast<std::size_t>(dy + kMiddle)];
  const std::uint64_t bit = std::uint64_t{1} << (dx + kMiddle);
  if (row & bit) return false;
  row |= bit;
  return true;
}

bool SmallFlood::mayBePlane(const CellRef& seed, const Plane& plane)
{
  struct Offset
  {
    std::int32_t x, y;
  };
  constexpr Offset kSteps[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  // a flood this small stays within the square
  if (m_search.minCells >= kMiddle) return true;
  std::array<Offset, kMiddle> cells;
  const auto rows = static_cast<std::size_t>(m_search.minCells) + 1;
  std::fill(m_visited.begin() + kMiddle - static_cast<std::ptrdiff_t>(rows),
            m_visited.begin() + kMiddle + static_cast<std::ptrdiff_t>(rows), 0);
  cells[0] = {0, 0};
  visit(0, 0);
  std::int32_t count = 1;
  for (std::int32_t i = 0; i < count && count < m_search.minCells; ++i)
  {
    const Offset from = cells[static_cast<std::size_t>(i)];
    for (const Offset& step : kSteps)
    {
      const Offset to{from.x + step.x, from.y + step.y};
      if (!visit(to.x, to.y)) continue;
      const CellRef cell = cellAt(*seed.tile, seed.ix + to.x, seed.iy + to.y);
      if (!cell || !cell.tile->isKnown(cell.ix, cell.iy)) continue;
      const std::size_t index = cell.index();
      if (cell.tile->plane[index] != kNoPlane ||
          !(std::fabs(static_cast<double>(cell.tile->height[index]) -
                      plane.at(cell.keyX(), cell.keyY())) <= m_search.tolerance))
        continue;
      cells[static_cast<std::size_t>(count++)] = to;
      if (count == m_search.minCells) return true;
    }
  }
  return count >= m_search.minCells;
}

}  // namespace mrpt_mapconv::terrain
