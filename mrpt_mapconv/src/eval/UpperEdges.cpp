#include <mrpt_mapconv/eval/UpperEdges.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::eval
{
namespace
{
constexpr double kSlack = 1e-5;  // [m]

/** The cells from whose floor it is more than `drop` down to a cell beside; or, with `sign` −1, up.
 * What is unknown, or beyond the layer, is beside none. */
CellMask cellsBesideDrops(const grid::Layer<float>& floor, double drop, double sign)
{
  params::require(std::isfinite(drop) && drop >= 0, "drop", drop, "a finite height >= 0 m");
  const grid::GridFrame& frame = floor.frame();
  CellMask edges(frame, 0);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
      for (std::int32_t ny = std::max(y - 1, 0); ny <= std::min(y + 1, frame.height - 1); ++ny)
        for (std::int32_t nx = std::max(x - 1, 0); nx <= std::min(x + 1, frame.width - 1); ++nx)
          if (sign * (double{floor.at(x, y)} - double{floor.at(nx, ny)}) > drop + kSlack)
            edges.at(x, y) = 1;
  return edges;
}
}  // namespace

CellMask upperEdges(const grid::Layer<float>& floor, double drop)
{
  return cellsBesideDrops(floor, drop, 1);
}

CellMask lowerEdges(const grid::Layer<float>& floor, double drop)
{
  return cellsBesideDrops(floor, drop, -1);
}

}  // namespace mrpt_mapconv::eval
