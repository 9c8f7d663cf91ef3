#include "ExhaustivePlanes.h"

#include <cmath>
#include <vector>

namespace mrpt_mapconv::oracle
{
namespace
{
struct Cell
{
  TerrainKey key;
  double z;
};

/** z = height + slopeX·(x − x0) + slopeY·(y − y0) through a cell and two others. */
struct PlaneThrough
{
  Cell first;
  double slopeX = 0, slopeY = 0;
  bool exists = false;

  PlaneThrough(const Cell& a, const Cell& b, const Cell& c) : first(a)
  {
    const double bx = b.key.second - a.key.second, by = b.key.first - a.key.first,
                 cx = c.key.second - a.key.second, cy = c.key.first - a.key.first;
    const double det = bx * cy - cx * by;
    if (det == 0) return;
    slopeX = ((b.z - a.z) * cy - (c.z - a.z) * by) / det;
    slopeY = (bx * (c.z - a.z) - cx * (b.z - a.z)) / det;
    exists = true;
  }
  bool holds(const Cell& cell, double tolerance) const
  {
    const double z = first.z + slopeX * (cell.key.second - first.key.second) +
                     slopeY * (cell.key.first - first.key.first);
    return std::abs(cell.z - z) <= tolerance;
  }
};

/** The cells that are connected to one on a plane. */
std::vector<TerrainKey> connectedOn(const PlaneThrough& plane, const std::vector<Cell>& cells,
                                    double tolerance)
{
  TerrainLabels on;
  for (const Cell& cell : cells)
    if (plane.holds(cell, tolerance)) on[cell.key] = 0;
  const TerrainLabels parts = connectedParts(on);
  std::vector<TerrainKey> part;
  for (const auto& [key, number] : parts)
    if (number == parts.at(plane.first.key)) part.push_back(key);
  return part;
}

std::size_t countOn(const PlaneThrough& plane, const std::vector<Cell>& cells, double tolerance)
{
  std::size_t count = 0;
  for (const Cell& cell : cells) count += plane.holds(cell, tolerance) ? 1 : 0;
  return count;
}

std::vector<TerrainKey> largestAt(const Cell& cell, const std::vector<Cell>& cells,
                                  double tolerance)
{
  std::vector<TerrainKey> largest;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = i + 1; j < cells.size(); ++j)
    {
      const PlaneThrough plane(cell, cells[i], cells[j]);
      if (!plane.exists || countOn(plane, cells, tolerance) <= largest.size()) continue;
      const auto part = connectedOn(plane, cells, tolerance);
      if (part.size() > largest.size()) largest = part;
    }
  return largest;
}
}  // namespace

TerrainLabels exhaustivePlanes(const TerrainHeights& heights, double tolerance,
                               std::size_t minCells)
{
  std::vector<Cell> cells;
  for (const auto& [key, z] : heights) cells.push_back({key, z});
  TerrainLabels planes;
  int number = 0;
  for (const Cell& cell : cells)
  {
    if (planes.count(cell.key)) continue;
    const auto part = largestAt(cell, cells, tolerance);
    const bool isPlane = part.size() >= minCells;
    planes[cell.key] = -1;
    if (!isPlane) continue;
    for (const TerrainKey& key : part) planes[key] = number;
    ++number;
  }
  return planes;
}

}  // namespace mrpt_mapconv::oracle
