#include <mrpt_mapconv/eval/DropDistance.h>
#include <mrpt_mapconv/grid/CellKey.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrpt_mapconv::eval
{
using mrpt::math::TPoint2D;

DropDistance::DropDistance(const grid::Layer<float>& floor, const CellMask& below, double drop)
    : m_floor(floor), m_drop(drop)
{
  const grid::GridFrame& frame = floor.frame();
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
      if (below.at(x, y))
        m_feet.push_back(
            {{frame.centreOf(frame.x0 + x), frame.centreOf(frame.y0 + y)}, double{floor.at(x, y)}});
}

double DropDistance::to(const TPoint2D& place) const
{
  const grid::GridFrame& frame = m_floor.frame();
  const auto kx = grid::cellKey(place.x, frame.resolution);
  const auto ky = grid::cellKey(place.y, frame.resolution);
  double least = std::numeric_limits<double>::infinity();
  if (!frame.containsKey(kx, ky)) return least;
  const double here{m_floor.cells()[frame.indexOfKey(kx, ky)]};
  const double half = frame.resolution / 2;
  for (const Foot& foot : m_feet)
  {
    if (!(here - foot.floor > m_drop)) continue;
    const double dx = std::max(std::abs(place.x - foot.centre.x) - half, 0.0);
    const double dy = std::max(std::abs(place.y - foot.centre.y) - half, 0.0);
    least = std::min(least, dx * dx + dy * dy);
  }
  return std::sqrt(least);
}

}  // namespace mrpt_mapconv::eval
