#pragma once

#include <vector>

#include "PassableCells.h"

namespace mrpt_mapconv::planning
{
/** The way from start to goal that mrpt::nav::PlannerSimple2D finds over the cells of a mask, both
 * ends included.
 *
 * \return cells of which each touches the next at a side, or at a corner between two more cells of
 * the mask; empty if the planner finds none, or slips between two cells outside the mask
 * \param start, goal inside the mask */
std::vector<Cell> wayOfMrptPlanner(const CellMask& mask, Cell start, Cell goal);

}  // namespace mrpt_mapconv::planning
