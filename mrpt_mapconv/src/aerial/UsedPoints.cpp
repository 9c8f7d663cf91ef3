#include "UsedPoints.h"

#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace mrpt_mapconv::aerial
{
namespace
{
constexpr double kMostCells = 1e8;

/** Whether keys of cells can be 32 bits. */
bool fitsKeys(const Range& range, double resolution)
{
  return std::max(std::abs(range.min), std::abs(range.max)) < 2e9 * resolution;
}
}  // namespace

Range rangeOf(const std::vector<double>& values, const UsedPoints& used)
{
  Range range;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!used[i]) continue;
    range.min = std::min(range.min, values[i]);
    range.max = std::max(range.max, values[i]);
  }
  return range;
}

double meanDistance(const cloud::PointCloud& cloud, const UsedPoints& used)
{
  const double area = rangeOf(cloud.x, used).length() * rangeOf(cloud.y, used).length();
  return std::sqrt(area / static_cast<double>(std::count(used.begin(), used.end(), 1)));
}

UsedPoints usablePoints(const cloud::PointCloud& cloud)
{
  UsedPoints used(cloud.size());
  for (std::size_t i = 0; i < used.size(); ++i)
    used[i] = std::isfinite(cloud.x[i]) && std::isfinite(cloud.y[i]) && std::isfinite(cloud.z[i]) &&
              (cloud.withheld.empty() || !cloud.withheld[i]);
  if (std::find(used.begin(), used.end(), 1) == used.end())
    throw std::runtime_error(
        "the cloud has no point that could be used: it is empty, or all "
        "points are withheld");
  return used;
}

grid::GridFrame frameAround(const cloud::PointCloud& cloud, const UsedPoints& used,
                            const Cells& cells)
{
  const Range x = rangeOf(cloud.x, used), y = rangeOf(cloud.y, used);
  const double sides = 2.0 * cells.margin + 2;
  const double count =
      (x.length() / cells.resolution + sides) * (y.length() / cells.resolution + sides);
  if (count > kMostCells || !fitsKeys(x, cells.resolution) || !fitsKeys(y, cells.resolution))
    throw std::runtime_error(mrpt::format(
        "the cloud spans %.6g x %.6g m, too much for %s = %g m: that would be %.3g cells, and at "
        "most %.3g are made; take larger cells, or look for stray points far away",
        x.length(), y.length(), cells.name, cells.resolution, count, kMostCells));
  grid::GridFrame frame;
  frame.resolution = cells.resolution;
  frame.shift = cells.shift;
  const auto key = [&](double metres)
  { return grid::cellKey(metres - frame.shift * frame.resolution, frame.resolution); };
  frame.x0 = key(x.min) - cells.margin;
  frame.y0 = key(y.min) - cells.margin;
  frame.width = key(x.max) + cells.margin + 1 - frame.x0;
  frame.height = key(y.max) + cells.margin + 1 - frame.y0;
  return frame;
}

}  // namespace mrpt_mapconv::aerial
