#include "SegmentColumns.h"

#include <mrpt_mapconv/grid/CellKey.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::path
{
namespace
{
using mrpt::math::TPoint3D;

/** Appends where a coordinate passes from one cell into the next, as shares of the way. */
void appendBorders(double from, double to, double resolution, std::vector<double>& shares)
{
  const auto [low, high] = std::minmax(from, to);
  const auto last = static_cast<std::int32_t>(std::floor(high / resolution)) + 1;
  for (std::int32_t key = grid::cellKey(low, resolution) + 1; key <= last; ++key)
    if (const double border = key * resolution; border > low && border < high)
      shares.push_back((border - from) / (to - from));
}

}  // namespace

std::vector<SegmentColumn> columnsOf(const TPoint3D& from, const TPoint3D& to, double resolution)
{
  constexpr double kTouch = 1e-6;  // of a cell: a shorter part of the way only touches the column
  std::vector<double> shares{0, 1};
  appendBorders(from.x, to.x, resolution, shares);
  appendBorders(from.y, to.y, resolution, shares);
  std::sort(shares.begin(), shares.end());

  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const auto column = [&](double begin, double end)
  {
    const TPoint3D way = to - from, middle = from + way * (0.5 * (begin + end));
    return SegmentColumn{grid::cellKey(middle.x, resolution), grid::cellKey(middle.y, resolution),
                         from + way * begin, from + way * end};
  };
  std::vector<SegmentColumn> columns;
  for (std::size_t i = 1; i < shares.size(); ++i)
    if ((shares[i] - shares[i - 1]) * length > kTouch * resolution)
      columns.push_back(column(shares[i - 1], shares[i]));
  if (columns.empty()) columns.push_back(column(0, 1));
  return columns;
}

}  // namespace mrpt_mapconv::path
