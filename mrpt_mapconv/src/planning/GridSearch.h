#pragma once

#include <mrpt_mapconv/planning/GridPlanner.h>

#include <optional>
#include <string>
#include <vector>

#include "BlockedSides.h"
#include "ClearPath.h"
#include "PassableCells.h"

namespace mrpt_mapconv::planning
{
/** planOnGrid() step by step: between searches, more can be learnt about cells. */
class GridSearch
{
 public:
  /** \param shownOrigin is added to places in words [m]
   * \exception std::invalid_argument as planOnGrid() */
  GridSearch(const grid::Layer<float>& occupancy, const mrpt::math::TPoint2D& start,
             const mrpt::math::TPoint2D& goal, double robotRadius,
             const mrpt::math::TPoint2D& shownOrigin = {});

  /** As planOnGrid(), with what has been said about cells since. */
  GridPath plan() const;

  /** The cells that the centre of the robot may enter. */
  const CellMask& passable() const { return m_passable; }
  /** The robot's centre is not to enter the cell; its neighbours are as before. */
  void exclude(Cell cell);
  /** The robot is to cross the cell only from side to side through its centre. */
  void keepToCentre(Cell cell);
  /** The robot is not to go from one cell to the one beside it, nor back; both are crossed through
   * their centres. */
  void blockSide(Cell a, Cell b);
  /** Straight segments that touch the cell must pass the test. */
  void testSegmentsIn(Cell cell) { m_untested.at(cell.x, cell.y) = 0; }
  void setSegmentTest(const SegmentTest& test) { m_segmentTest = test; }
  /** Whether the robot may be anywhere in the cell. */
  bool isOpen(Cell cell) const { return holds(m_open, cell); }

  /** Start or goal, if the robot cannot stand there; its cell, if it has one. */
  std::optional<Cell> badEnd() const { return m_badEnd; }
  /** The cells that the robot can reach. \pre the robot can stand at the start */
  CellMask reachable() const;

 private:
  std::vector<Waypoint> bestPath(const Waypoint& from, const Waypoint& to) const;
  bool isClearSegment(const Waypoint& from, const Waypoint& to) const;
  std::vector<Cell> keptToCentres(const std::vector<Cell>& way) const;
  std::vector<Cell> mrptWay(CellMask reached, Cell from, Cell to) const;

  mrpt::math::TPoint2D m_start, m_goal, m_shownOrigin;
  double m_robotRadius;
  CellMask m_passable;
  CellMask m_open;      //!< those among them that need not be crossed through their centres
  CellMask m_untested;  //!< those whose segments need no test
  SegmentTest m_segmentTest;
  BlockedSides m_blocked;
  std::string m_problem;  //!< of start or goal
  std::optional<Cell> m_badEnd;
};

}  // namespace mrpt_mapconv::planning
