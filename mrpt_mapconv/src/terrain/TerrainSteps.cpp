#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include "InnerPlane.h"
#include "PlaneRows.h"
#include "TerrainMapImpl.h"

namespace mrpt_mapconv::terrain
{
namespace
{
/** Cells between two planes that belong to neither, those of the riser: noise mixes what is above
 * with what is below on either side of it. */
std::int32_t mostGap(double resolution)
{
  constexpr double kMixed = 0.12;  // [m]
  return std::clamp(static_cast<std::int32_t>(std::ceil(kMixed / resolution)), 2, kTileSide - 1);
}

/** Where two planes meet, from pairs of cells that face each other. */
struct Meeting
{
  double x = 0, y = 0;                //!< Σ of where they meet [m]
  double towardsX = 0, towardsY = 0;  //!< Σ of directions from the first to the second
  double gap = 0;                     //!< Σ of the cells between them
  std::size_t pairs = 0;

  double length() const { return std::hypot(towardsX, towardsY); }
  void add(const Meeting& o)
  {
    x += o.x;
    y += o.y;
    towardsX += o.towardsX;
    towardsY += o.towardsY;
    gap += o.gap;
    pairs += o.pairs;
  }
};
/** By the direction from the first plane to the second: east, west, north, south. */
using Sides = std::array<Meeting, 4>;
using Meetings = std::map<std::pair<std::int32_t, std::int32_t>, Sides>;

/** One, along which two planes meet; or, if they meet all around as a platform and its floor do,
 * one for each side. */
std::vector<Meeting> meetingsOf(const Sides& sides)
{
  Meeting all;
  for (const Meeting& side : sides) all.add(side);
  // 0.7 or more along a straight line in any direction
  if (all.length() >= 0.5 * static_cast<double>(all.pairs)) return {all};
  std::vector<Meeting> meetings;
  std::copy_if(sides.begin(), sides.end(), std::back_inserter(meetings),
               [](const Meeting& side) { return side.pairs > 0; });
  return meetings;
}

/** The first plane beyond a cell in a direction, at most `gap` cells without a plane away. */
CellRef facing(const CellRef& from, std::int32_t dx, std::int32_t dy, std::int32_t gap)
{
  for (std::int32_t i = 1; i <= gap + 1; ++i)
  {
    const CellRef cell = cellAt(*from.tile, from.ix + i * dx, from.iy + i * dy);
    if (!cell || !cell.tile->isKnown(cell.ix, cell.iy)) return {};
    if (cell.tile->plane[cell.index()] != kNoPlane) return cell;
  }
  return {};
}

void addMeetings(Tile& tile, const TerrainMap& map, const std::vector<std::int32_t>& indices,
                 Meetings& meetings)
{
  const std::int32_t gap = mostGap(map.resolution());
  const auto addOf = [&](std::int32_t ix, std::int32_t iy, std::int32_t dx, std::int32_t dy)
  {
    const CellRef cell{&tile, ix, iy}, other = facing(cell, dx, dy, gap);
    if (!other) return;
    const std::int32_t a = indices[static_cast<std::size_t>(tile.plane[cell.index()])],
                       b = indices[static_cast<std::size_t>(other.tile->plane[other.index()])];
    if (a == b) return;
    const std::int32_t sign = a < b ? 1 : -1;
    const double x = 0.5 * map.resolution() * (cell.keyX() + other.keyX()),
                 y = 0.5 * map.resolution() * (cell.keyY() + other.keyY());
    const std::int32_t between =
        std::max(std::abs(other.keyX() - cell.keyX()), std::abs(other.keyY() - cell.keyY())) - 1;
    const std::size_t side = (dx != 0 ? 0u : 2u) + (sign > 0 ? 0u : 1u);
    meetings[{std::min(a, b), std::max(a, b)}][side].add({x, y, static_cast<double>(sign * dx),
                                                          static_cast<double>(sign * dy),
                                                          static_cast<double>(between), 1});
  };
  for (std::int32_t iy = 0; iy < kTileSide; ++iy)
  {
    const RowBits assigned = tile.assigned[static_cast<std::size_t>(iy)];
    if (!assigned) continue;
    forEachBit(assigned & differsEast(tile, iy), [&](std::int32_t ix) { addOf(ix, iy, 1, 0); });
    forEachBit(assigned & differsNorth(tile, iy), [&](std::int32_t ix) { addOf(ix, iy, 0, 1); });
  }
}

/** The height of a plane at its edge. Mixed heights tilt small planes, to one side at the lower
 * edge of a tread and to the other at its upper one: what is no steeper than the tolerance explains
 * is taken for level. */
double heightFor(const TerrainPlane& plane, double x, double y, double tolerance)
{
  constexpr double kSmall = 0.5;  // [m]
  constexpr double kEdges = 3;    // times the tolerance, from one edge to the other
  const double width = plane.xMax - plane.xMin, depth = plane.yMax - plane.yMin;
  const double rise = std::abs(plane.slopeX) * width + std::abs(plane.slopeY) * depth;
  return std::min(width, depth) <= kSmall && rise <= kEdges * tolerance ? plane.z
                                                                        : plane.heightAt(x, y);
}

/** How far a plane reaches in a direction: the median over lines in that direction, each a cell
 * apart [m]. */
double depthOf(const std::vector<CellRef>& cells, double directionX, double directionY,
               double resolution)
{
  struct Reach
  {
    double least = 1e300, most = -1e300;
  };
  std::map<long, Reach> lines;
  for (const CellRef& cell : cells)
  {
    const double along = cell.keyX() * directionX + cell.keyY() * directionY,
                 across = cell.keyY() * directionX - cell.keyX() * directionY;
    Reach& reach = lines[std::lround(across)];
    reach.least = std::min(reach.least, along);
    reach.most = std::max(reach.most, along);
  }
  std::vector<double> depths;
  for (const auto& line : lines) depths.push_back(line.second.most - line.second.least + 1);
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle * resolution;
}
/** Whether the upper plane of a step ends at another one: by which it goes on up, or down again. */
bool endsTread(const TerrainStep& step, const TerrainStep& other)
{
  const double cosine = step.directionX * other.directionX + step.directionY * other.directionY;
  return (other.lower == step.upper && cosine > 0.9) ||
         (other.upper == step.upper && cosine < -0.9);
}
}  // namespace

std::vector<TerrainStep> TerrainMap::steps() const
{
  Meetings meetings;
  std::vector<std::vector<CellRef>> cells(planes().size());
  for (Tile* tile : m_impl->tiles.sorted())
  {
    addMeetings(*tile, *this, m_impl->indices, meetings);
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      forEachBit(tile->assigned[static_cast<std::size_t>(iy)],
                 [&](std::int32_t ix)
                 {
                   const CellRef cell{tile, ix, iy};
                   const std::int32_t index = m_impl->indexOf(tile->plane[cell.index()]);
                   cells[static_cast<std::size_t>(index)].push_back(cell);
                 });
  }
  const double size = resolution();
  std::vector<TerrainPlane> inner;
  for (std::size_t i = 0; i < cells.size(); ++i)
    inner.push_back(innerPlane(planes()[i], cells[i], m_impl->search.minCells, size));
  std::vector<TerrainStep> steps;
  std::vector<double> gaps;
  const auto addStep =
      [&](const std::pair<std::int32_t, std::int32_t>& planes, const Meeting& meeting)
  {
    const auto n = static_cast<double>(meeting.pairs);
    const auto levelOf = [&](std::int32_t plane)
    {
      return heightFor(inner[static_cast<std::size_t>(plane)], meeting.x / n, meeting.y / n,
                       m_impl->params.planeTolerance);
    };
    const double rise = levelOf(planes.second) - levelOf(planes.first), length = meeting.length();
    if (std::abs(rise) <= m_impl->params.planeTolerance) return;
    const double sign = rise > 0 ? 1 : -1;
    TerrainStep step;
    step.lower = rise > 0 ? planes.first : planes.second;
    step.upper = rise > 0 ? planes.second : planes.first;
    step.height = std::abs(rise);
    step.width = length * size;
    step.x = meeting.x / n;
    step.y = meeting.y / n;
    step.directionX = sign * meeting.towardsX / length;
    step.directionY = sign * meeting.towardsY / length;
    step.depth = depthOf(cells[static_cast<std::size_t>(step.upper)], step.directionX,
                         step.directionY, size);
    steps.push_back(step);
    gaps.push_back(meeting.gap / n * size);
  };
  for (const auto& [planes, sides] : meetings)
    for (const Meeting& meeting : meetingsOf(sides)) addStep(planes, meeting);
  // half of the cells between two planes belongs to each
  std::vector<double> more(steps.size(), 0);
  std::multimap<std::int32_t, std::size_t> beside;  // steps by either of their planes
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    beside.emplace(steps[i].lower, i);
    beside.emplace(steps[i].upper, i);
  }
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    more[i] += gaps[i] / 2;
    const auto around = beside.equal_range(steps[i].upper);
    const auto next =
        std::find_if(around.first, around.second,
                     [&](const auto& entry) { return endsTread(steps[i], steps[entry.second]); });
    if (next != around.second) more[i] += gaps[next->second] / 2;
  }
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i].depth += more[i];
  std::stable_sort(steps.begin(), steps.end(),
                   [](const TerrainStep& a, const TerrainStep& b)
                   { return std::tie(a.lower, a.upper) < std::tie(b.lower, b.upper); });
  return steps;
}

}  // namespace mrpt_mapconv::terrain
