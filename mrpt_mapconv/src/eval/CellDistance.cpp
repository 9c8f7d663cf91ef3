#include <mrpt_mapconv/eval/CellDistance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrpt_mapconv::eval
{
using mrpt::math::TPoint2D;

CellDistance::CellDistance(const CellMask& mask) : m_half(mask.frame().resolution / 2)
{
  const grid::GridFrame& frame = mask.frame();
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
      if (mask.at(x, y))
        m_centres.emplace_back((frame.x0 + x + 0.5) * frame.resolution,
                               (frame.y0 + y + 0.5) * frame.resolution);
}

double CellDistance::to(const TPoint2D& place) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const TPoint2D& centre : m_centres)
  {
    const double dx = std::max(std::abs(place.x - centre.x) - m_half, 0.0);
    const double dy = std::max(std::abs(place.y - centre.y) - m_half, 0.0);
    least = std::min(least, dx * dx + dy * dy);
  }
  return std::sqrt(least);
}

}  // namespace mrpt_mapconv::eval
