#pragma once

#include <mrpt_mapconv/planning/GridPlanner.h>

#include <string>
#include <vector>

#include "ClearPath.h"
#include "PassableCells.h"

namespace mrpt_mapconv::planning
{
/** planOnGrid() step by step: between searches, more can be learnt about cells. */
class GridSearch
{
 public:
  /** \exception std::invalid_argument as planOnGrid() */
  GridSearch(const grid::Layer<float>& occupancy, const mrpt::math::TPoint2D& start,
             const mrpt::math::TPoint2D& goal, double robotRadius);

  /** As planOnGrid(), with what has been said about cells since. */
  GridPath plan() const;

  /** The cells that the centre of the robot may enter. */
  const CellMask& passable() const { return m_passable; }
  /** The robot's centre is not to enter the cell; its neighbours are as before. */
  void exclude(Cell cell);
  /** The robot is to cross the cell only from side to side through its centre. */
  void keepToCentre(Cell cell);
  /** Whether the robot may be anywhere in the cell. */
  bool isOpen(Cell cell) const { return holds(m_open, cell); }

 private:
  std::vector<Waypoint> bestPath(const Waypoint& from, const Waypoint& to) const;

  mrpt::math::TPoint2D m_start, m_goal;
  double m_robotRadius;
  CellMask m_passable;
  CellMask m_open;        //!< those among them that need not be crossed through their centres
  std::string m_problem;  //!< of start or goal
};

}  // namespace mrpt_mapconv::planning
