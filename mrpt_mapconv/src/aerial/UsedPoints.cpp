#include "UsedPoints.h"

#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace mrpt_mapconv::aerial
{
namespace
{
constexpr double kMostCells = 1e8;

/** How many squares of that side [m] have a used point. */
std::size_t occupiedCells(const cloud::PointCloud& cloud, const UsedPoints& used, double side)
{
  std::vector<std::pair<std::int32_t, std::int32_t>> cells;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i])
      cells.emplace_back(grid::cellKey(cloud.x[i], side), grid::cellKey(cloud.y[i], side));
  std::sort(cells.begin(), cells.end());
  return static_cast<std::size_t>(std::unique(cells.begin(), cells.end()) - cells.begin());
}

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
  const auto points = static_cast<double>(std::count(used.begin(), used.end(), 1));
  double distance =
      std::sqrt(rangeOf(cloud.x, used).length() * rangeOf(cloud.y, used).length() / points);
  // the rectangle may be nearly empty, because of one stray point; so may be large cells
  constexpr int kMostTries = 10;
  constexpr double kCellDistances = 4, kCloseEnough = 0.95;
  for (int i = 0; i < kMostTries && distance > kFineDistance; ++i)
  {
    const double cell = kCellDistances * distance;
    const double better =
        cell * std::sqrt(static_cast<double>(occupiedCells(cloud, used, cell)) / points);
    if (better > kCloseEnough * distance) break;
    distance = better;
  }
  return distance;
}

bool isNoise(const cloud::PointCloud& cloud, std::size_t point)
{
  constexpr std::uint8_t kLowNoise = 7, kHighNoise = 18;  // of the ASPRS
  return !cloud.classification.empty() &&
         (cloud.classification[point] == kLowNoise || cloud.classification[point] == kHighNoise);
}

UsedPoints usablePoints(const cloud::PointCloud& cloud)
{
  UsedPoints used(cloud.size());
  for (std::size_t i = 0; i < used.size(); ++i)
    used[i] = std::isfinite(cloud.x[i]) && std::isfinite(cloud.y[i]) && std::isfinite(cloud.z[i]) &&
              (cloud.withheld.empty() || !cloud.withheld[i]) && !isNoise(cloud, i);
  if (std::find(used.begin(), used.end(), 1) == used.end())
    throw std::runtime_error(
        "the cloud has no point that could be used: it is empty, or all points are withheld or "
        "classified as noise");
  return used;
}

grid::GridFrame frameAround(const cloud::PointCloud& cloud, const UsedPoints& used,
                            const Cells& cells)
{
  const Range x = rangeOf(cloud.x, used), y = rangeOf(cloud.y, used);
  const double sides = 2.0 * cells.margin + 2;
  const double count =
      (x.length() / cells.resolution + sides) * (y.length() / cells.resolution + sides);
  if (!fitsKeys(x, cells.resolution) || !fitsKeys(y, cells.resolution))
    throw std::runtime_error(mrpt::format(
        "its points lie up to %.6g m from the origin, too far for %s = %g m; another --origin, or "
        "larger cells, would do",
        std::max({std::abs(x.min), std::abs(x.max), std::abs(y.min), std::abs(y.max)}), cells.name,
        cells.resolution));
  if (count > kMostCells)
    throw std::runtime_error(mrpt::format(
        "the cloud spans %.6g x %.6g m, too much for %s = %g m: that would be %.3g cells, and at "
        "most %.3g are made; %.2g m would do, unless stray points far away or another unit than "
        "metres are the reason",
        x.length(), y.length(), cells.name, cells.resolution, count, kMostCells,
        1.1 * cells.resolution * std::sqrt(count / kMostCells)));
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
