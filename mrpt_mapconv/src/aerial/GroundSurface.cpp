#include "GroundSurface.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::aerial
{
namespace
{
/** The two cells of a row or column that a place lies between. */
struct Between
{
  std::int32_t lower, upper;
  float share;  // of the upper one
};

Between between(double metres, double firstCentre, double resolution, std::int32_t cells)
{
  const double place = std::clamp((metres - firstCentre) / resolution, 0.0, cells - 1.0);
  const auto lower = static_cast<std::int32_t>(place);
  return {lower, std::min(lower + 1, cells - 1), static_cast<float>(place - lower)};
}

float mix(float a, float b, float shareOfB) { return a + (b - a) * shareOfB; }
}  // namespace

float interpolate(const grid::Layer<float>& layer, double x, double y)
{
  const grid::GridFrame& f = layer.frame();
  const Between u = between(x, f.centreOf(f.x0), f.resolution, f.width);
  const Between v = between(y, f.centreOf(f.y0), f.resolution, f.height);
  const auto inRow = [&](std::int32_t iy)
  { return mix(layer.at(u.lower, iy), layer.at(u.upper, iy), u.share); };
  return mix(inRow(v.lower), inRow(v.upper), v.share);
}

grid::Layer<float> slopeOf(const grid::Layer<float>& surface, std::int32_t reach)
{
  const grid::GridFrame& f = surface.frame();
  grid::Layer<float> slope(f, 0);
  for (std::int32_t y = 0; y < f.height; ++y)
    for (std::int32_t x = 0; x < f.width; ++x)
    {
      const std::int32_t left = std::max(x - reach, 0), right = std::min(x + reach, f.width - 1);
      const std::int32_t down = std::max(y - reach, 0), up = std::min(y + reach, f.height - 1);
      const double dx = std::max(right - left, 1) * f.resolution;
      const double dy = std::max(up - down, 1) * f.resolution;
      slope.at(x, y) =
          static_cast<float>(std::hypot((surface.at(right, y) - surface.at(left, y)) / dx,
                                        (surface.at(x, up) - surface.at(x, down)) / dy));
    }
  return slope;
}

}  // namespace mrpt_mapconv::aerial
