#include "PassableCells.h"

#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace mrpt_mapconv::planning
{
namespace
{
/** For each column offset 0, 1, … the number of rows up and down within which a cell blocks. */
std::vector<std::int32_t> blockedRows(double radius, std::int32_t limit)
{
  std::vector<std::int32_t> rows;
  // a radius of whole cells in decimal metres must not lose one to rounding
  const double least = std::max(radius - 1e-9, 0.0);
  const auto blocks = [&](std::int32_t dx, std::int32_t dy)
  { return (dx == 0 && dy == 0) || squaredGap(dx, dy) < least * least; };
  for (std::int32_t dx = 0; dx <= limit && blocks(dx, 0); ++dx)
  {
    std::int32_t dy = rows.empty() ? limit : rows.back();
    while (!blocks(dx, dy)) --dy;
    rows.push_back(dy);
  }
  return rows;
}

/** For each cell the number of rows to the nearest one of its column that is not free. */
grid::Layer<std::int32_t> rowsToObstacle(const grid::Layer<float>& occupancy)
{
  const grid::GridFrame& frame = occupancy.frame();
  grid::Layer<std::int32_t> rows(frame, 0);
  const auto sweep = [&](std::int32_t iy, std::int32_t iyBefore, bool first)
  {
    const bool edge = iyBefore < 0 || iyBefore >= frame.height;
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      if (grid::isFree(occupancy.at(ix, iy)))
      {
        const std::int32_t here = edge ? 1 : rows.at(ix, iyBefore) + 1;
        rows.at(ix, iy) = first ? here : std::min(rows.at(ix, iy), here);
      }
  };
  for (std::int32_t iy = 0; iy < frame.height; ++iy) sweep(iy, iy - 1, true);
  for (std::int32_t iy = frame.height; iy-- > 0;) sweep(iy, iy + 1, false);
  return rows;
}

}  // namespace

double squaredGap(std::int32_t dx, std::int32_t dy)
{
  const double x = std::max(std::abs(dx) - 1, 0), y = std::max(std::abs(dy) - 1, 0);
  return x * x + y * y;
}

CellMask passableCells(const grid::Layer<float>& occupancy, double radius)
{
  const grid::GridFrame& frame = occupancy.frame();
  const auto rows = rowsToObstacle(occupancy);
  const auto blocked = blockedRows(radius, std::max(frame.width, frame.height) + 1);
  const auto reach = static_cast<std::int32_t>(blocked.size()) - 1;
  CellMask passable(frame, 0);
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
  {
    const std::int32_t* distance = rows.row(iy);
    for (std::int32_t ix = reach; ix < frame.width - reach; ++ix)
    {
      bool clear = distance[ix] > blocked[0];
      for (std::int32_t dx = 1; clear && dx <= reach; ++dx)
      {
        const std::int32_t up = blocked[static_cast<std::size_t>(dx)];
        clear = distance[ix - dx] > up && distance[ix + dx] > up;
      }
      passable.at(ix, iy) = clear;
    }
  }
  return passable;
}

}  // namespace mrpt_mapconv::planning
