#pragma once

#include "PassableCells.h"

namespace mrpt_mapconv::planning
{
/** Sides of cells that are not to be crossed, in either direction. */
class BlockedSides
{
 public:
  BlockedSides() = default;
  explicit BlockedSides(const grid::GridFrame& frame) : m_sides(frame, 0) {}

  /** \param a, b cells inside, of which one is beside the other */
  void block(Cell a, Cell b)
  {
    m_sides.at(a.x, a.y) = static_cast<std::uint8_t>(m_sides.at(a.x, a.y) | side(a, b));
    m_sides.at(b.x, b.y) = static_cast<std::uint8_t>(m_sides.at(b.x, b.y) | side(b, a));
  }
  /** \param a, b as for block() */
  bool between(Cell a, Cell b) const { return (m_sides.at(a.x, a.y) & side(a, b)) != 0; }
  /** Whether a cell has such a side. */
  bool any(Cell cell) const { return m_sides.at(cell.x, cell.y) != 0; }

 private:
  static int side(Cell from, Cell to)
  {
    return to.x > from.x ? 1 : to.x < from.x ? 2 : to.y > from.y ? 4 : 8;
  }

  CellMask m_sides;  //!< bits of the four sides
};

}  // namespace mrpt_mapconv::planning
