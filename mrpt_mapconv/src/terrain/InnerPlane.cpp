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

InnerPlane::InnerPlane(const TerrainPlane& all, const std::vector<CellRef>& cells,
                       std::int64_t minCells, double resolution)
    : m_all(all), m_resolution(resolution)
{
  const double border = std::min<double>(std::ceil(kBorder / resolution), kTileSide - 1);
  const CellRef& first = cells.front();
  PlaneMoments moments(first.keyX(), first.keyY(), first.tile->height[first.index()]);
  for (const CellRef& cell : cells)
    if (isInside(cell, static_cast<std::int32_t>(border)))
      moments.add(cell.keyX(), cell.keyY(), cell.tile->height[cell.index()]);
  if (moments.cells() >= minCells && moments.spans()) m_inner = moments.fit();
}

double InnerPlane::heightAt(double x, double y) const
{
  if (!m_inner) return m_all.heightAt(x, y);
  return kHeightUnit * (m_inner->height + m_inner->slopeX * (x / m_resolution - m_inner->originX) +
                        m_inner->slopeY * (y / m_resolution - m_inner->originY));
}

}  // namespace mrpt_mapconv::terrain
