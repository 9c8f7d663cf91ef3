#include "GridSearch.h"

#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "CellFlood.h"
#include "MrptPlanner.h"
#include "PassableCells.h"

namespace mrpt_mapconv::planning
{
namespace
{
using grid::GridFrame;
using grid::Layer;
using mrpt::math::TPoint2D;
using params::require;
using params::roundedText;

std::string inMetres(const TPoint2D& p)
{
  return "(" + params::placeText(p.x) + ", " + params::placeText(p.y) + ") m";
}

void checkInput(const Layer<float>& occupancy, const TPoint2D& start, const TPoint2D& goal,
                double robotRadius)
{
  const double resolution = occupancy.frame().resolution;
  if (occupancy.frame().empty()) throw std::invalid_argument("plan: the layer has no cells");
  require(std::isfinite(resolution) && resolution > 0, "plan: resolution", resolution,
          "positive [m]");
  require(std::isfinite(start.x), "plan: start x", start.x, "finite [m]");
  require(std::isfinite(start.y), "plan: start y", start.y, "finite [m]");
  require(std::isfinite(goal.x), "plan: goal x", goal.x, "finite [m]");
  require(std::isfinite(goal.y), "plan: goal y", goal.y, "finite [m]");
  require(std::isfinite(robotRadius) && robotRadius >= 0, "plan: robot radius", robotRadius,
          "finite and not negative [m]");
}

bool contains(const GridFrame& frame, const TPoint2D& p)
{
  return p.x >= frame.xMin() && p.x < frame.xMax() && p.y >= frame.yMin() && p.y < frame.yMax();
}

/** The waypoint of a place that the frame contains. */
Waypoint waypointAt(const GridFrame& frame, const TPoint2D& p)
{
  return {{grid::cellKey(p.x, frame.resolution) - frame.x0,
           grid::cellKey(p.y, frame.resolution) - frame.y0},
          p};
}

TPoint2D centreOf(const GridFrame& frame, Cell cell)
{
  return {(frame.x0 + cell.x + 0.5) * frame.resolution,
          (frame.y0 + cell.y + 0.5) * frame.resolution};
}

const char* kindOf(float occupancy) { return grid::isOccupied(occupancy) ? "occupied" : "unknown"; }

/** In words, what comes nearest to a free cell, and how near. */
std::string nearestObstacle(const Layer<float>& occupancy, Cell cell, const TPoint2D& origin)
{
  const GridFrame& frame = occupancy.frame();
  const std::int32_t toEdge = std::min(std::min(cell.x, frame.width - 1 - cell.x),
                                       std::min(cell.y, frame.height - 1 - cell.y));
  double least = squaredGap(toEdge + 1, 0);
  std::string what = "the map's edge";
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
    {
      const double gap = squaredGap(ix - cell.x, iy - cell.y);
      if (gap >= least || grid::isFree(occupancy.at(ix, iy))) continue;
      least = gap;
      what = std::string("the ") + kindOf(occupancy.at(ix, iy)) + " cell at " +
             inMetres(centreOf(frame, {ix, iy}) + origin);
    }
  return roundedText(std::sqrt(least) * frame.resolution) + " m of " + what;
}

/** Why the robot cannot stand at a place; empty if it can. \param origin of places in words */
std::string problemAt(const char* name, const TPoint2D& p, const Layer<float>& occupancy,
                      const CellMask& passable, double robotRadius, const TPoint2D& origin)
{
  using params::placeText;
  const GridFrame& frame = occupancy.frame();
  std::ostringstream text;
  text << name << " " << inMetres(p + origin);
  if (!contains(frame, p))
  {
    text << " is outside the map, which covers x from " << placeText(frame.xMin() + origin.x)
         << " to " << placeText(frame.xMax() + origin.x) << " m and y from "
         << placeText(frame.yMin() + origin.y) << " to " << placeText(frame.yMax() + origin.y)
         << " m";
    return text.str();
  }
  const Cell cell = waypointAt(frame, p).cell;
  const float value = occupancy.at(cell.x, cell.y);
  if (!grid::isFree(value))
  {
    text << " is in an " << kindOf(value) << " cell";
    return text.str();
  }
  if (holds(passable, cell)) return {};
  text << " is too near to an obstacle: its free cell comes within "
       << nearestObstacle(occupancy, cell, origin) << ", the robot's radius is " << robotRadius
       << " m";
  return text.str();
}

/** A way over cells as a path from start to goal, through the cells' centres. */
std::vector<Waypoint> throughCentres(const GridFrame& frame, const Waypoint& start,
                                     const Waypoint& goal, const std::vector<Cell>& way)
{
  std::vector<Waypoint> path{start};
  for (const Cell& cell : way) path.push_back({cell, centreOf(frame, cell)});
  path.push_back(goal);
  return path;
}

/** The points of a path, of which neighbours differ. */
std::vector<TPoint2D> pointsOf(const std::vector<Waypoint>& path)
{
  std::vector<TPoint2D> points;
  for (const Waypoint& waypoint : path)
    if (points.empty() || points.back() != waypoint.point) points.push_back(waypoint.point);
  return points;
}

}  // namespace

GridSearch::GridSearch(const Layer<float>& occupancy, const TPoint2D& start, const TPoint2D& goal,
                       double robotRadius, const TPoint2D& shownOrigin)
    : m_start(start), m_goal(goal), m_shownOrigin(shownOrigin), m_robotRadius(robotRadius)
{
  checkInput(occupancy, start, goal, robotRadius);
  const GridFrame& frame = occupancy.frame();
  m_passable = passableCells(occupancy, robotRadius / frame.resolution);
  m_untested = m_open = m_passable;
  m_blocked = BlockedSides(frame);
  for (const auto& [name, place] : {std::pair{"start", start}, {"goal", goal}})
  {
    m_problem = problemAt(name, place, occupancy, m_passable, robotRadius, shownOrigin);
    if (m_problem.empty()) continue;
    if (contains(frame, place)) m_badEnd = waypointAt(frame, place).cell;
    return;
  }
}

void GridSearch::exclude(Cell cell)
{
  m_passable.at(cell.x, cell.y) = m_open.at(cell.x, cell.y) = 0;
}

void GridSearch::keepToCentre(Cell cell) { m_open.at(cell.x, cell.y) = 0; }

void GridSearch::blockSide(Cell a, Cell b)
{
  m_blocked.block(a, b);
  keepToCentre(a);
  keepToCentre(b);
}

CellMask GridSearch::reachable() const
{
  return CellFlood(m_passable, m_blocked, waypointAt(m_passable.frame(), m_start).cell).reached();
}

GridPath GridSearch::plan() const
{
  if (!m_problem.empty()) return {{}, m_problem};
  const Waypoint from = waypointAt(m_passable.frame(), m_start);
  const Waypoint to = waypointAt(m_passable.frame(), m_goal);
  if (holds(m_passable, from.cell) && holds(m_passable, to.cell))
    if (const auto path = bestPath(from, to); !path.empty()) return {pointsOf(path), {}};

  std::ostringstream problem;
  problem << "start " << inMetres(m_start + m_shownOrigin) << " and goal "
          << inMetres(m_goal + m_shownOrigin) << " are not connected for a robot with a radius of "
          << m_robotRadius << " m";
  return {{}, problem.str()};
}

/** Whether the robot may go straight, not only from one cell to the next through their centres. */
bool GridSearch::isClearSegment(const Waypoint& from, const Waypoint& to) const
{
  return isClear(m_open, from, to) && (isClear(m_untested, from, to) || m_segmentTest(from, to));
}

/** Makes side steps of the diagonal ones that are not clear. */
std::vector<Cell> GridSearch::keptToCentres(const std::vector<Cell>& way) const
{
  const GridFrame& frame = m_passable.frame();
  std::vector<Cell> kept;
  for (const Cell& cell : way)
  {
    const Cell last = kept.empty() ? cell : kept.back();
    if (last.x != cell.x && last.y != cell.y &&
        !isClearSegment({last, centreOf(frame, last)}, {cell, centreOf(frame, cell)}))
      kept.push_back({last.x, cell.y});
    kept.push_back(cell);
  }
  return kept;
}

/** MRPT's planner knows no blocked sides, so it gets none of the cells that have some. */
std::vector<Cell> GridSearch::mrptWay(CellMask reached, Cell from, Cell to) const
{
  for (std::int32_t iy = 0; iy < reached.frame().height; ++iy)
    for (std::int32_t ix = 0; ix < reached.frame().width; ++ix)
      if (m_blocked.any({ix, iy})) reached.at(ix, iy) = 0;
  if (!holds(reached, from) || !holds(reached, to)) return {};
  return wayOfMrptPlanner(reached, from, to);
}

/** The shorter of the planner's and the flood's path whose steps are all clear; empty if there is
 * none. */
std::vector<Waypoint> GridSearch::bestPath(const Waypoint& from, const Waypoint& to) const
{
  if (isClearSegment(from, to)) return {from, to};
  const CellFlood flood(m_passable, m_blocked, from.cell);
  if (!holds(flood.reached(), to.cell)) return {};
  const GridFrame& frame = m_passable.frame();
  std::vector<Waypoint> best;
  for (const auto& way : {mrptWay(flood.reached(), from.cell, to.cell), flood.wayTo(to.cell)})
  {
    const auto full = throughCentres(frame, from, to, keptToCentres(way));
    if (way.empty() || !isClear(flood.reached(), full)) continue;
    const auto path = shortened(
        [this](const Waypoint& a, const Waypoint& b) { return isClearSegment(a, b); }, full);
    if (best.empty() || length(path) < length(best)) best = path;
  }
  return best;
}

GridPath planOnGrid(const grid::Layer<float>& occupancy, const mrpt::math::TPoint2D& start,
                    const mrpt::math::TPoint2D& goal, double robotRadius)
{
  return GridSearch(occupancy, start, goal, robotRadius).plan();
}

}  // namespace mrpt_mapconv::planning
