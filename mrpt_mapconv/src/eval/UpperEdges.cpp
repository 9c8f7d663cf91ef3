#include <mrpt_mapconv/eval/UpperEdges.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::eval
{
namespace
{
constexpr double kSlack = 1e-5;  // [m]

/** The lowest known floor of a cell and the 8 around it, those that the layer has [m]; infinite if
 * none is known. */
float lowestAround(const grid::Layer<float>& floor, std::int32_t x, std::int32_t y)
{
  const grid::GridFrame& frame = floor.frame();
  float lowest = INFINITY;
  for (std::int32_t ny = std::max(y - 1, 0); ny <= std::min(y + 1, frame.height - 1); ++ny)
    for (std::int32_t nx = std::max(x - 1, 0); nx <= std::min(x + 1, frame.width - 1); ++nx)
      lowest = std::fmin(lowest, floor.at(nx, ny));  // which passes over NaN
  return lowest;
}
}  // namespace

CellMask upperEdges(const grid::Layer<float>& floor, double drop)
{
  params::require(std::isfinite(drop) && drop >= 0, "drop", drop, "a finite height >= 0 m");
  CellMask edges(floor.frame(), 0);
  for (std::int32_t y = 0; y < floor.frame().height; ++y)
    for (std::int32_t x = 0; x < floor.frame().width; ++x)
      edges.at(x, y) = double{floor.at(x, y)} - double{lowestAround(floor, x, y)} > drop + kSlack;
  return edges;
}

}  // namespace mrpt_mapconv::eval
