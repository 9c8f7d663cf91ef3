#include "ClearPath.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mrpt_mapconv::planning
{
namespace
{
struct CellPlace
{
  double x, y;  //!< [cells] from the mask's corner
};

/** A segment along its longer axis: its minor coordinate over its major one [cells]. */
struct MajorSegment
{
  double begin, end;   //!< major coordinates, begin ≤ end
  double minor, rise;  //!< minor coordinate at `begin`; change over the whole segment

  /** Minor coordinate at a major one within the segment. */
  double at(double major) const
  {
    return begin < end ? minor + rise * (major - begin) / (end - begin) : minor;
  }
};

}  // namespace

bool isClear(const CellMask& mask, const Waypoint& from, const Waypoint& to)
{
  if (from.cell == to.cell) return holds(mask, from.cell);

  constexpr double kTouch = 1e-6;  // of a cell: nearer than that counts as touched
  const grid::GridFrame& frame = mask.frame();
  const auto inCells = [&](const Waypoint& w) -> CellPlace {
    return {w.point.x / frame.resolution - frame.x0, w.point.y / frame.resolution - frame.y0};
  };
  CellPlace a = inCells(from), b = inCells(to);
  const bool swapped = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  if (swapped)
  {
    std::swap(a.x, a.y);
    std::swap(b.x, b.y);
  }
  if (b.x < a.x) std::swap(a, b);
  const MajorSegment segment{a.x, b.x, a.y, b.y - a.y};

  const auto key = [](double coordinate)
  { return static_cast<std::int32_t>(std::floor(coordinate)); };
  const std::int32_t last = key(segment.end + kTouch);
  for (std::int32_t major = key(segment.begin - kTouch); major <= last; ++major)
  {
    const double p = segment.at(std::clamp<double>(major, segment.begin, segment.end));
    const double q = segment.at(std::clamp<double>(major + 1, segment.begin, segment.end));
    const std::int32_t minorLast = key(std::max(p, q) + kTouch);
    for (std::int32_t minor = key(std::min(p, q) - kTouch); minor <= minorLast; ++minor)
      if (!holds(mask, swapped ? Cell{minor, major} : Cell{major, minor})) return false;
  }
  return true;
}

bool isClear(const CellMask& mask, const std::vector<Waypoint>& path)
{
  return std::adjacent_find(path.begin(), path.end(),
                            [&](const Waypoint& from, const Waypoint& to)
                            { return !isClear(mask, from, to); }) == path.end();
}

std::vector<Waypoint> shortened(const SegmentTest& isClear, const std::vector<Waypoint>& path)
{
  if (path.empty()) return {};
  std::vector<Waypoint> kept{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i)
    if (i + 1 == path.size() || !isClear(kept.back(), path[i + 1])) kept.push_back(path[i]);
  return kept;
}

double length(const std::vector<Waypoint>& path)
{
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += std::hypot(path[i].point.x - path[i - 1].point.x, path[i].point.y - path[i - 1].point.y);
  return sum;
}

}  // namespace mrpt_mapconv::planning
