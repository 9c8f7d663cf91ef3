#include "CellFlood.h"

#include <algorithm>
#include <array>

namespace mrpt_mapconv::planning
{
namespace
{
constexpr std::array<Cell, 4> kSteps{Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}};
}

CellFlood::CellFlood(const CellMask& passable, const BlockedSides& blocked, Cell start)
    : m_start(start), m_reached(passable.frame(), 0), m_cameFrom(passable.frame(), 0)
{
  std::vector<Cell> front{start}, next;
  m_reached.at(start.x, start.y) = 1;
  for (; !front.empty(); front.swap(next))
  {
    next.clear();
    for (const Cell& from : front)
      for (std::size_t s = 0; s < kSteps.size(); ++s)
      {
        const Cell to{from.x + kSteps[s].x, from.y + kSteps[s].y};
        if (!holds(passable, to) || holds(m_reached, to) || blocked.between(from, to)) continue;
        m_reached.at(to.x, to.y) = 1;
        m_cameFrom.at(to.x, to.y) = static_cast<std::uint8_t>(s);
        next.push_back(to);
      }
  }
}

std::vector<Cell> CellFlood::wayTo(Cell goal) const
{
  std::vector<Cell> way{goal};
  for (Cell cell = goal; cell != m_start; way.push_back(cell))
  {
    const Cell& step = kSteps[m_cameFrom.at(cell.x, cell.y)];
    cell = {cell.x - step.x, cell.y - step.y};
  }
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace mrpt_mapconv::planning
