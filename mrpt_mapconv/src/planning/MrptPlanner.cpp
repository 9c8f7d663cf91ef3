#include "MrptPlanner.h"

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/nav/planners/PlannerSimple2D.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <exception>

namespace mrpt_mapconv::planning
{
namespace
{
/** Where the planner works: the mask's bounding box, padded, because the planner treats its two
 * outer rows otherwise and looks beyond a cell without a check. */
grid::GridFrame planningFrame(const CellMask& mask)
{
  constexpr std::int32_t kPadding = 3;  // ceil(0/resolution) + 3: the mask is inflated already
  const grid::GridFrame& frame = mask.frame();
  Cell low{frame.width, frame.height}, high{-1, -1};
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      if (mask.at(ix, iy) != 0)
      {
        low = {std::min(low.x, ix), std::min(low.y, iy)};
        high = {std::max(high.x, ix), std::max(high.y, iy)};
      }
  // in cells from the mask's corner, so that MRPT's float limits hold every place exactly
  return {1.0, low.x - kPadding, low.y - kPadding, high.x - low.x + 1 + 2 * kPadding,
          high.y - low.y + 1 + 2 * kPadding};
}

void copyMask(const CellMask& mask, const grid::GridFrame& frame,
              mrpt::maps::COccupancyGridMap2D& map)
{
  constexpr float kBlocked = 1.0f;
  grid::Layer<float> layer(frame, kBlocked);
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      if (holds(mask, {ix + frame.x0, iy + frame.y0})) layer.at(ix, iy) = grid::kFree;
  grid::copyToGridMap(layer, map);
}

/** The planner's points, of which the first is not the start; empty if it finds no path. */
std::deque<mrpt::math::TPoint2D> pointsOfPlanner(const mrpt::maps::COccupancyGridMap2D& map,
                                                 Cell start, Cell goal)
{
  mrpt::nav::PlannerSimple2D planner;
  planner.robotRadius = 0;
  planner.minStepInReturnedPath = 0;  // every cell
  const auto centre = [](Cell cell) { return mrpt::poses::CPose2D(cell.x + 0.5, cell.y + 0.5, 0); };
  std::deque<mrpt::math::TPoint2D> points;
  bool notFound = true;
  try
  {
    planner.computePath(map, centre(start), centre(goal), points, notFound);
  }
  catch (const std::exception&)  // its 16-bit counters overflow on very long ways
  {
    notFound = true;
  }
  if (notFound) points.clear();
  return points;
}

/** Appends a neighbouring cell, around the corner where the straight step would cut one.
 * \return false where that cannot be */
bool appendStep(const CellMask& mask, Cell to, std::vector<Cell>& way)
{
  const Cell from = way.back();
  if (to == from) return true;
  if (!holds(mask, to) || std::abs(to.x - from.x) > 1 || std::abs(to.y - from.y) > 1) return false;
  const Cell corners[] = {{from.x, to.y}, {to.x, from.y}};
  const bool clear[] = {holds(mask, corners[0]), holds(mask, corners[1])};
  if (!clear[0] && !clear[1]) return false;
  if (!clear[0] || !clear[1]) way.push_back(corners[clear[0] ? 0 : 1]);
  way.push_back(to);
  return true;
}

}  // namespace

std::vector<Cell> wayOfMrptPlanner(const CellMask& mask, Cell start, Cell goal)
{
  constexpr std::int32_t kLargestSide = 65535;  // its cell indices have 16 bits
  const grid::GridFrame frame = planningFrame(mask);
  if (std::max(frame.width, frame.height) > kLargestSide) return {};
  mrpt::maps::COccupancyGridMap2D map;
  copyMask(mask, frame, map);
  std::vector<Cell> way{start};
  for (const auto& point : pointsOfPlanner(map, start, goal))
    if (!appendStep(mask,
                    {static_cast<std::int32_t>(std::floor(point.x)),
                     static_cast<std::int32_t>(std::floor(point.y))},
                    way))
      return {};
  if (way.back() != goal) return {};
  return way;
}

}  // namespace mrpt_mapconv::planning
