#include "RobotPlanner.h"

#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "FloorSteps.h"
#include "WhyNotFree.h"

namespace mrpt_mapconv::planning
{
namespace
{
using mrpt::math::TPoint2D;
using path::LiftedPath;

RobotPath without(const std::string& problem) { return {{}, problem}; }

/** What is wrong with a point of a path, without its number. */
GridSearch searchFor(const freespace::Layers& layers, const RobotPathQuery& query)
{
  const auto& origin = query.lift.shownOrigin;
  return {freespace::occupancyFor(layers, query.lift.robot),
          query.start,
          query.goal,
          query.robotRadius,
          {origin.x, origin.y}};
}

std::string placeAndReason(const LiftedPath& path, std::size_t index)
{
  const std::string text = path.describeProblem(index);
  return text.empty() ? text : text.substr(text.find("at ("));
}
}  // namespace

RobotPlanner::RobotPlanner(const freespace::Layers& layers,
                           const freespace::ConversionParams& conversion,
                           const RobotPathQuery& query, const voxel::VoxelSource* voxels)
    : m_layers(layers),
      m_conversion(conversion),
      m_query(query),
      m_voxels(voxels),
      m_search(searchFor(layers, query)),
      m_faults(layers, conversion, query.lift, voxels),
      m_looked(layers.frame(), 0)
{
  if (isGround())
    blockFloorSteps(freespace::heightsFor(layers, query.lift.robot),
                    path::StepLimit(conversion, layers.frame().resolution), m_search);
}

RobotPath RobotPlanner::plan()
{
  for (int attempt = 0; attempt < m_query.mostAttempts; ++attempt)
  {
    const GridPath way = m_search.plan();
    if (!way.found()) return without(m_firstMisfit.empty() ? whyNoWay(way.problem) : blockedWay());
    const LiftedPath path = lift(way.points);
    const auto faults = path.feasible() ? m_faults.of(path) : std::vector<WayFault>{};
    if (path.feasible() && faults.empty()) return {path, {}};
    if (const std::string problem = problemOfEnds(path); !problem.empty()) return without(problem);
    if (m_firstMisfit.empty())
      m_firstMisfit =
          faults.empty() ? placeAndReason(path, *path.firstProblem()) : faults.front().words;
    if (faults.empty())
      learnMisfits(path);
    else if (!leadAround(path, faults))
      return without(blockedWay());
  }
  return without("no path in 3D among the first " + std::to_string(m_query.mostAttempts) +
                 " that were tried, there may be another; what was wrong with the first, " +
                 m_firstMisfit);
}

LiftedPath RobotPlanner::lift(const std::vector<TPoint2D>& points) const
{
  return path::liftPath(points, m_layers, m_conversion, m_query.lift, m_voxels);
}

LiftedPath RobotPlanner::liftCentre(Cell cell) const
{
  const grid::GridFrame& frame = m_layers.frame();
  return lift({{(frame.x0 + cell.x + 0.5) * frame.resolution,
                (frame.y0 + cell.y + 0.5) * frame.resolution}});
}

/** \param x, y a place on the layers [m] */
Cell RobotPlanner::cellOf(double x, double y) const
{
  const grid::GridFrame& frame = m_layers.frame();
  return {grid::cellKey(x, frame.resolution) - frame.x0,
          grid::cellKey(y, frame.resolution) - frame.y0};
}

Cell RobotPlanner::cellOf(const path::LiftedPoint& point) const
{
  return cellOf(point.position.x, point.position.y);
}

/** Why there is no path whatever lies between; empty if the ends are good. */
std::string RobotPlanner::problemOfEnds(const LiftedPath& path) const
{
  const std::size_t last = path.points.size() - 1;
  for (const auto& [name, place, index] :
       {std::tuple{"start", m_query.start, std::size_t{0}}, {"goal", m_query.goal, last}})
  {
    if (const auto problem = placeAndReason(path, index); !problem.empty())
      return name + (" " + problem);
    const LiftedPath centre = liftCentre(cellOf(place.x, place.y));
    if (!centre.feasible())
      return name + (": the centre of its cell, " + placeAndReason(centre, 0));
  }
  return {};
}

/** Why not even the first search has found a way. */
std::string RobotPlanner::whyNoWay(const std::string& problem) const
{
  if (const auto end = m_search.badEnd())
  {
    const std::string why = whyNotFree(m_layers, m_conversion, m_query.lift.robot, *end);
    return why.empty() ? problem : problem + ": " + why;
  }
  const std::string step = isGround() ? stepInTheWay() : "";
  return step.empty() ? problem : "there is a way in 2D, but not in 3D: " + step;
}

/** Where the way that there would be without steps leaves what a ground robot can reach; empty if
 * there is no such way. */
std::string RobotPlanner::stepInTheWay() const
{
  const GridPath way = searchFor(m_layers, m_query).plan();
  if (!way.found()) return {};
  const LiftedPath path = lift(way.points);
  const auto faults = m_faults.of(path);
  if (faults.empty()) return {};
  const CellMask reachable = m_search.reachable();
  const auto leaves = [&](const WayFault& fault)
  {
    return fault.kind == WayFault::Kind::FloorStep &&
           holds(reachable, cellOf(path.points[fault.index - 1])) &&
           !holds(reachable, cellOf(path.points[fault.index]));
  };
  // the last one: steps before it are gone around, or the way would not have been there again
  const auto found = std::find_if(faults.rbegin(), faults.rend(), leaves);
  return found == faults.rend() ? faults.front().words : found->words;
}

std::string RobotPlanner::blockedWay() const
{
  return (m_ledAround ? "no path in 3D was found, though there is a way in 2D; "
                      : "there is a way in 2D, but not in 3D: ") +
         m_firstMisfit;
}

/** Leads the next way elsewhere, or through more cells' centres. \return false if there is nothing
 * left to try */
bool RobotPlanner::leadAround(const LiftedPath& path, const std::vector<WayFault>& faults)
{
  m_ledAround = true;
  bool other = false;
  for (const WayFault& fault : faults) other |= keepToCentres(path, fault);
  for (auto fault = faults.begin(); !other && fault != faults.end(); ++fault)
    other = exclude(path, *fault);
  return other;
}

/** From centre to centre a step of the floor is a cell long, and so is one of the heights if all
 * points that decide about it lie there. \return false if that is so already */
bool RobotPlanner::keepToCentres(const LiftedPath& path, const WayFault& fault)
{
  std::size_t first = fault.index - 1, last = fault.index;
  if (fault.kind == WayFault::Kind::HeightStep)
  {
    const double cells = m_query.lift.lookahead / m_layers.frame().resolution;
    // points are at least half a cell apart, but for those at the path's corners
    const auto reach = static_cast<std::size_t>(std::min(2 * cells + 2, 1e6));
    first -= std::min(first, reach);
    last = std::min(last + reach, path.points.size() - 1);
  }
  bool any = false;
  for (std::size_t i = first; i <= last; ++i)
  {
    const Cell cell = cellOf(path.points[i]);
    any |= m_search.isOpen(cell);
    m_search.keepToCentre(cell);
  }
  return any;
}

/** Excludes one of a fault's two cells: which heights come before is up to the way. \return false
 * if they are start and goal */
bool RobotPlanner::exclude(const LiftedPath& path, const WayFault& fault)
{
  const Cell start = cellOf(m_query.start.x, m_query.start.y);
  const Cell goal = cellOf(m_query.goal.x, m_query.goal.y);
  for (const std::size_t index : {fault.index, fault.index - 1})
    if (const Cell cell = cellOf(path.points[index]); cell != start && cell != goal)
    {
      m_search.exclude(cell);
      return true;
    }
  return false;
}

void RobotPlanner::learnMisfits(const LiftedPath& path)
{
  std::vector<Cell> misfits;
  for (const auto& point : path.points)
  {
    if (point.problem == path::Infeasibility::None) continue;
    lookAt(cellOf(point), misfits);
    m_search.keepToCentre(cellOf(point));
  }
  excludeAround(misfits);
}

/** Excludes a cell if the robot does not fit in its centre, and appends it to the misfits. */
void RobotPlanner::lookAt(Cell cell, std::vector<Cell>& misfits)
{
  if (!holds(m_search.passable(), cell) || holds(m_looked, cell)) return;
  m_looked.at(cell.x, cell.y) = 1;
  if (liftCentre(cell).feasible()) return;
  m_search.exclude(cell);
  misfits.push_back(cell);
}

/** Excludes more misfits around those known, since they come in patches. */
void RobotPlanner::excludeAround(std::vector<Cell>& misfits)
{
  constexpr std::size_t kMost = 10'000;  // so that an attempt stays quick in a hopeless map
  for (std::size_t i = 0; i < misfits.size() && misfits.size() < kMost; ++i)
  {
    const Cell centre = misfits[i];
    for (std::int32_t dy = -1; dy <= 1; ++dy)
      for (std::int32_t dx = -1; dx <= 1; ++dx) lookAt({centre.x + dx, centre.y + dy}, misfits);
  }
}

}  // namespace mrpt_mapconv::planning
