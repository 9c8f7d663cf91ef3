#pragma once

#include <mrpt_mapconv/grid/Layer.h>

#include <cstdint>

namespace mrpt_mapconv::planning
{
/** Column and row of a cell, counted from the frame's corner. */
struct Cell
{
  std::int32_t x = 0, y = 0;
  bool operator==(const Cell& o) const { return x == o.x && y == o.y; }
  bool operator!=(const Cell& o) const { return !(*this == o); }
};

/** 1 where something holds for a cell, else 0. */
using CellMask = grid::Layer<std::uint8_t>;

/** Whether the cell lies inside and the mask holds there. */
inline bool holds(const CellMask& mask, Cell cell)
{
  return cell.x >= 0 && cell.y >= 0 && cell.x < mask.frame().width &&
         cell.y < mask.frame().height && mask.at(cell.x, cell.y) != 0;
}

/** Squared gap between the squares of two cells that are dx columns and dy rows apart [cells²]. */
double squaredGap(std::int32_t dx, std::int32_t dy);

/** The free cells whose gap to every cell that is not free, or not on the layer, is at least the
 * radius [cells, ≥ 0], up to a billionth of a cell. */
CellMask passableCells(const grid::Layer<float>& occupancy, double radius);

}  // namespace mrpt_mapconv::planning
