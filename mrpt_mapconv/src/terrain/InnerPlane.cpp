#include "InnerPlane.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::terrain
{
namespace
{
constexpr double kBorder = 0.06;  // [m], 3 standard deviations of a range of usual sensors

/** Whether a cell's plane goes on for that many cells in each direction. */
bool isInside(const CellRef& cell, std::int32_t reach)
{
  const std::int32_t id = cell.tile->plane[cell.index()];
  const auto goesOn = [&](std::int32_t dx, std::int32_t dy)
  {
    const CellRef other = cellAt(*cell.tile, cell.ix + dx, cell.iy + dy);
    return other && other.tile->plane[other.index()] == id;
  };
  return goesOn(reach, 0) && goesOn(-reach, 0) && goesOn(0, reach) && goesOn(0, -reach);
}
}  // namespace

TerrainPlane innerPlane(const TerrainPlane& all, const std::vector<CellRef>& cells,
                        std::int64_t minCells, double resolution)
{
  const double border = std::min<double>(std::ceil(kBorder / resolution), kTileSide - 1);
  const CellRef& first = cells.front();
  PlaneMoments moments(first.keyX(), first.keyY(), first.tile->height[first.index()]);
  for (const CellRef& cell : cells)
    if (isInside(cell, static_cast<std::int32_t>(border)))
      moments.add(cell.keyX(), cell.keyY(), cell.tile->height[cell.index()]);
  if (moments.cells() < minCells || !moments.spans()) return all;
  const Plane fitted = moments.fit();
  TerrainPlane inner = all;
  inner.slopeX = fitted.slopeX * kHeightUnit / resolution;
  inner.slopeY = fitted.slopeY * kHeightUnit / resolution;
  inner.x = moments.meanX() * resolution;
  inner.y = moments.meanY() * resolution;
  inner.z = kHeightUnit * (fitted.height + fitted.slopeX * (moments.meanX() - fitted.originX) +
                           fitted.slopeY * (moments.meanY() - fitted.originY));
  return inner;
}

}  // namespace mrpt_mapconv::terrain
