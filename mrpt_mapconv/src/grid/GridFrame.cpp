#include <mrpt_mapconv/grid/GridFrame.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace mrpt_mapconv::grid
{
namespace
{
std::int32_t extent(std::int32_t begin, std::int32_t end)
{
  const std::int64_t size = static_cast<std::int64_t>(end) - begin;
  if (size > std::numeric_limits<std::int32_t>::max())
    throw std::length_error(
        "GridFrame: the united frame would be " + std::to_string(size) + " cells wide, at most " +
        std::to_string(std::numeric_limits<std::int32_t>::max()) + " can be addressed");
  return static_cast<std::int32_t>(size);
}
}  // namespace

GridFrame unite(const GridFrame& a, const GridFrame& b)
{
  if (b.empty()) return a;
  if (a.empty()) return b;
  if (a.resolution != b.resolution)
    throw std::invalid_argument("GridFrame: cannot unite resolutions " +
                                std::to_string(a.resolution) + " m and " +
                                std::to_string(b.resolution) + " m, they must be equal");
  if (a.shift != b.shift)
    throw std::invalid_argument("GridFrame: cannot unite frames whose cells are shifted otherwise");
  GridFrame out = a;
  out.x0 = std::min(a.x0, b.x0);
  out.y0 = std::min(a.y0, b.y0);
  out.width = extent(out.x0, std::max(a.xEnd(), b.xEnd()));
  out.height = extent(out.y0, std::max(a.yEnd(), b.yEnd()));
  return out;
}

}  // namespace mrpt_mapconv::grid
