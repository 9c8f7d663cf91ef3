#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/planning/GridPlanner.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "CellFlood.h"
#include "ClearPath.h"
#include "MrptPlanner.h"
#include "PassableCells.h"

namespace mrpt_mapconv::planning
{
namespace
{
using grid::GridFrame;
using grid::Layer;
using mrpt::math::TPoint2D;

std::string inMetres(const TPoint2D& p)
{
  std::ostringstream text;
  text << "(" << p.x << ", " << p.y << ") m";
  return text.str();
}

void check(const char* name, double value, bool valid, const char* right)
{
  if (valid) return;
  std::ostringstream message;
  message << "plan: " << name << " = " << value << " is not valid: it must be " << right;
  throw std::invalid_argument(message.str());
}

void checkInput(const Layer<float>& occupancy, const TPoint2D& start, const TPoint2D& goal,
                double robotRadius)
{
  const double resolution = occupancy.frame().resolution;
  if (occupancy.frame().empty()) throw std::invalid_argument("plan: the layer has no cells");
  check("resolution", resolution, std::isfinite(resolution) && resolution > 0, "positive [m]");
  check("start x", start.x, std::isfinite(start.x), "finite [m]");
  check("start y", start.y, std::isfinite(start.y), "finite [m]");
  check("goal x", goal.x, std::isfinite(goal.x), "finite [m]");
  check("goal y", goal.y, std::isfinite(goal.y), "finite [m]");
  check("robot radius", robotRadius, std::isfinite(robotRadius) && robotRadius >= 0,
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
std::string nearestObstacle(const Layer<float>& occupancy, Cell cell)
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
             inMetres(centreOf(frame, {ix, iy}));
    }
  std::ostringstream text;
  text << std::sqrt(least) * frame.resolution << " m of " << what;
  return text.str();
}

/** Why the robot cannot stand at a place; empty if it can. */
std::string problemAt(const char* name, const TPoint2D& p, const Layer<float>& occupancy,
                      const CellMask& passable, double robotRadius)
{
  const GridFrame& frame = occupancy.frame();
  std::ostringstream text;
  text << name << " " << inMetres(p);
  if (!contains(frame, p))
  {
    text << " is outside the map, which covers x from " << frame.xMin() << " to " << frame.xMax()
         << " m and y from " << frame.yMin() << " to " << frame.yMax() << " m";
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
       << nearestObstacle(occupancy, cell) << ", the robot's radius is " << robotRadius << " m";
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

/** The shorter of the planner's and the flood's path whose segments are all clear; empty if there
 * is none. */
std::vector<Waypoint> bestPath(const CellFlood& flood, const Waypoint& start, const Waypoint& goal)
{
  const CellMask& mask = flood.reached();
  if (isClear(mask, start, goal)) return {start, goal};
  std::vector<Waypoint> best;
  for (const auto& way : {wayOfMrptPlanner(mask, start.cell, goal.cell), flood.wayTo(goal.cell)})
  {
    const auto full = throughCentres(mask.frame(), start, goal, way);
    if (way.empty() || !isClear(mask, full)) continue;
    const auto path = shortened(mask, full);
    if (best.empty() || length(path) < length(best)) best = path;
  }
  return best;
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

GridPath planOnGrid(const Layer<float>& occupancy, const TPoint2D& start, const TPoint2D& goal,
                    double robotRadius)
{
  checkInput(occupancy, start, goal, robotRadius);
  const GridFrame& frame = occupancy.frame();
  const CellMask passable = passableCells(occupancy, robotRadius / frame.resolution);
  for (const auto& [name, place] : {std::pair{"start", start}, std::pair{"goal", goal}})
    if (const auto problem = problemAt(name, place, occupancy, passable, robotRadius);
        !problem.empty())
      return {{}, problem};

  const Waypoint from = waypointAt(frame, start), to = waypointAt(frame, goal);
  const CellFlood flood(passable, from.cell);
  const auto path =
      holds(flood.reached(), to.cell) ? bestPath(flood, from, to) : std::vector<Waypoint>{};
  if (!path.empty()) return {pointsOf(path), {}};

  std::ostringstream problem;
  problem << "start " << inMetres(start) << " and goal " << inMetres(goal)
          << " are not connected for a robot with a radius of " << robotRadius << " m";
  return {{}, problem.str()};
}

}  // namespace mrpt_mapconv::planning
