#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "../grid/Parallel.h"
#include "EmptyCells.h"

namespace mrpt_mapconv::aerial
{
using grid::Layer;

namespace
{
constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

/** For each cell the nearest one with a height in its column, or kNobody. */
std::vector<std::uint32_t> nearestInColumns(const Layer<float>& heights)
{
  const auto width = static_cast<std::uint32_t>(heights.frame().width);
  const auto size = static_cast<std::uint32_t>(heights.cells().size());
  const float* z = heights.cells().data();
  std::vector<std::uint32_t> nearest(size, kNobody);
  for (std::uint32_t cell = 0; cell < size; ++cell)
    if (!std::isnan(z[cell]))
      nearest[cell] = cell;
    else if (cell >= width)
      nearest[cell] = nearest[cell - width];
  for (std::uint32_t cell = size; cell-- > 0;)
  {
    if (cell + width >= size) continue;
    const std::uint32_t above = nearest[cell + width], below = nearest[cell];
    if (above == kNobody || above <= cell) continue;
    const auto key = [&](std::uint32_t source)
    { return std::make_tuple((source > cell ? source - cell : cell - source) / width, z[source]); };
    if (below == kNobody || key(above) < key(below)) nearest[cell] = above;
  }
  return nearest;
}
}  // namespace

std::vector<std::uint32_t> nearestMeasured(const Layer<float>& heights, int threads)
{
  const std::vector<std::uint32_t> inColumn = nearestInColumns(heights);
  std::vector<std::uint32_t> nearest(inColumn.size(), kNobody);
  const auto width = static_cast<std::int64_t>(heights.frame().width);
  const auto findNearest = [&](std::int64_t cell)
  {
    const std::int64_t x = cell % width, y = cell / width;
    auto best = std::make_tuple(std::numeric_limits<std::int64_t>::max(), 0.0F, kNobody);
    const auto consider = [&](std::int64_t u)
    {
      if (u < 0 || u >= width) return;
      const std::uint32_t source = inColumn[static_cast<std::size_t>(cell + u - x)];
      if (source == kNobody) return;
      const std::int64_t dy = source / width - y;
      best = std::min(best, {(u - x) * (u - x) + dy * dy, heights.cells()[source], source});
    };
    for (std::int64_t dx = 0; dx < width && dx * dx <= std::get<0>(best); ++dx)
    {
      consider(x - dx);
      consider(x + dx);
    }
    nearest[static_cast<std::size_t>(cell)] = std::get<2>(best);
  };
  grid::inParallel(nearest.size(), threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     for (std::size_t i = begin; i < end; ++i)
                       findNearest(static_cast<std::int64_t>(i));
                   });
  return nearest;
}

}  // namespace mrpt_mapconv::aerial
