#pragma once

#include <vector>

#include "BlockedSides.h"
#include "PassableCells.h"

namespace mrpt_mapconv::planning
{
/** What can be reached from a cell over the sides of passable cells, but for blocked ones, breadth
 * first. */
class CellFlood
{
 public:
  CellFlood(const CellMask& passable, const BlockedSides& blocked, Cell start);

  /** The cells that can be reached, the start among them. */
  const CellMask& reached() const { return m_reached; }

  /** A shortest way to a reached cell, side by side, both ends included. */
  std::vector<Cell> wayTo(Cell goal) const;

 private:
  Cell m_start;
  CellMask m_reached;
  CellMask m_cameFrom;  //!< index into the steps
};

}  // namespace mrpt_mapconv::planning
