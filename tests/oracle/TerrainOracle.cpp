#include "TerrainOracle.h"

#include <algorithm>
#include <set>

namespace mrpt_mapconv::oracle
{
namespace
{
/** The cells that are connected to one of the same label. */
std::vector<TerrainKey> partFrom(const TerrainLabels& labels, const TerrainKey& first)
{
  const int label = labels.at(first);
  std::vector<TerrainKey> part{first};
  std::set<TerrainKey> seen{first};
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    const auto [y, x] = part[i];
    for (const TerrainKey& next :
         {TerrainKey{y, x + 1}, TerrainKey{y, x - 1}, TerrainKey{y + 1, x}, TerrainKey{y - 1, x}})
    {
      const auto found = labels.find(next);
      if (found == labels.end() || found->second != label) continue;
      if (seen.insert(next).second) part.push_back(next);
    }
  }
  return part;
}

bool areOnOneLine(const std::vector<TerrainKey>& cells)
{
  const auto [y0, x0] = cells.front();
  const auto [y1, x1] = cells.back();
  return std::all_of(cells.begin(), cells.end(),
                     [&, y = y0, x = x0, dy = y1 - y0, dx = x1 - x0](const TerrainKey& cell)
                     { return (cell.first - y) * dx == (cell.second - x) * dy; });
}

int floorTo(int key, int side)
{
  const int rest = ((key % side) + side) % side;
  return key - rest;
}

bool isOfOnePlane(const TerrainLabels& planes, int x0, int y0, int side, int plane)
{
  for (int y = y0; y < y0 + side; ++y)
    for (int x = x0; x < x0 + side; ++x)
    {
      const auto found = planes.find({y, x});
      if (found == planes.end() || found->second != plane) return false;
    }
  return true;
}

TerrainSquare leafOf(const TerrainLabels& planes, const TerrainKey& cell)
{
  TerrainSquare leaf{cell.second, cell.first, 1, planes.at(cell)};
  while (leaf.plane >= 0)
  {
    const int side = 2 * leaf.side, x = floorTo(leaf.x, side), y = floorTo(leaf.y, side);
    if (!isOfOnePlane(planes, x, y, side, leaf.plane)) break;
    leaf = {x, y, side, leaf.plane};
  }
  return leaf;
}

/** Whether a Morton code comes before another: y decides where it differs at a bit as high. */
bool comesBefore(const TerrainSquare& a, const TerrainSquare& b)
{
  const auto raised = [](int key) { return static_cast<unsigned>(key) ^ 0x80000000u; };
  const unsigned x = raised(a.x) ^ raised(b.x), y = raised(a.y) ^ raised(b.y);
  const bool isHigherInX = y < x && y < (x ^ y);
  return isHigherInX ? raised(a.x) < raised(b.x) : raised(a.y) < raised(b.y);
}
}  // namespace

TerrainLabels planesOfCells(const terrain::TerrainMap& map)
{
  TerrainLabels planes;
  const grid::GridFrame frame = map.frame();
  for (int y = frame.y0; y < frame.yEnd(); ++y)
    for (int x = frame.x0; x < frame.xEnd(); ++x)
      if (const auto point = map.at(x * map.resolution(), y * map.resolution()))
        planes[{y, x}] = point->plane;
  return planes;
}

TerrainLabels connectedParts(const TerrainLabels& labels)
{
  TerrainLabels parts;
  int number = 0;
  for (const auto& [key, label] : labels)
  {
    if (label < 0) parts[key] = -1;
    if (parts.count(key)) continue;
    for (const TerrainKey& cell : partFrom(labels, key)) parts[cell] = number;
    ++number;
  }
  return parts;
}

TerrainLabels truePlanes(const TerrainLabels& labels, std::size_t minCells)
{
  TerrainLabels planes;
  int number = 0;
  for (const auto& [key, label] : labels)
  {
    if (planes.count(key)) continue;
    std::vector<TerrainKey> part{key};
    if (label >= 0) part = partFrom(labels, key);
    const bool isPlane = part.size() >= minCells && !areOnOneLine(part);
    for (const TerrainKey& cell : part) planes[cell] = isPlane ? number : -1;
    if (isPlane) ++number;
  }
  return planes;
}

std::vector<TerrainSquare> leavesOf(const TerrainLabels& planes)
{
  std::vector<TerrainSquare> leaves;
  std::set<TerrainKey> covered;
  for (const auto& entry : planes)
  {
    if (covered.count(entry.first)) continue;
    const TerrainSquare leaf = leafOf(planes, entry.first);
    leaves.push_back(leaf);
    for (int y = leaf.y; y < leaf.y + leaf.side; ++y)
      for (int x = leaf.x; x < leaf.x + leaf.side; ++x) covered.insert({y, x});
  }
  std::sort(leaves.begin(), leaves.end(), comesBefore);
  return leaves;
}

}  // namespace mrpt_mapconv::oracle
