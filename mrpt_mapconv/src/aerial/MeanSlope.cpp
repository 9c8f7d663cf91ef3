#include "MeanSlope.h"

namespace mrpt_mapconv::aerial
{
namespace
{
double middleOf(std::int32_t cells) { return (cells - 1) / 2.0; }
}  // namespace

MeanSlope MeanSlope::of(const grid::Layer<float>& surface)
{
  const grid::GridFrame& frame = surface.frame();
  const double midX = middleOf(frame.width), midY = middleOf(frame.height);
  double xz = 0, yz = 0, xx = 0, yy = 0;
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
    {
      const double x = ix - midX, y = iy - midY, z = surface.at(ix, iy);
      xz += x * z, yz += y * z, xx += x * x, yy += y * y;
    }
  // on a full rectangle of cells x and y do not correlate
  return {xx > 0 ? xz / xx : 0, yy > 0 ? yz / yy : 0};
}

void tilt(grid::Layer<float>& heights, const MeanSlope& slope)
{
  const grid::GridFrame& frame = heights.frame();
  const double midX = middleOf(frame.width), midY = middleOf(frame.height);
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      heights.at(ix, iy) += static_cast<float>(slope.x * (ix - midX) + slope.y * (iy - midY));
}

}  // namespace mrpt_mapconv::aerial
