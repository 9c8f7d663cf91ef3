#include "DiscOpening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../grid/Parallel.h"
#include "../grid/Wide.h"

namespace mrpt_mapconv::aerial
{
using grid::Layer;

namespace
{
/** The disc's rows, from −radius to radius: how many cells each reaches to either side. */
std::vector<std::size_t> halfWidths(std::int32_t radius)
{
  std::vector<std::size_t> widths;
  for (std::int32_t dy = -radius; dy <= radius; ++dy)
  {
    std::int32_t half = 0;
    while ((half + 1) * (half + 1) + dy * dy <= radius * radius) ++half;
    widths.push_back(static_cast<std::size_t>(half));
  }
  return widths;
}

MRPT_MAPCONV_WIDE
void lowerEach(float* __restrict out, const float* __restrict a, std::size_t n)
{
  for (std::size_t i = 0; i < n; ++i) out[i] = a[i] < out[i] ? a[i] : out[i];
}

/** The lowest of 1, 2, 4, … successive cells of a row that has a margin on both sides. */
class RowMinima
{
 public:
  RowMinima(std::size_t width, std::size_t margin) : m_width(width), m_margin(margin) {}

  void take(const float* row)
  {
    const std::size_t longest = 2 * m_margin + 1;
    m_minima.assign(
        1, std::vector<float>(m_width + 2 * m_margin, std::numeric_limits<float>::infinity()));
    std::copy_n(row, m_width, m_minima[0].begin() + static_cast<std::ptrdiff_t>(m_margin));
    for (std::size_t length = 1; 2 * length <= longest; length *= 2)
    {
      std::vector<float> next = m_minima.back();
      lowerEach(next.data(), m_minima.back().data() + length, next.size() - length);
      m_minima.push_back(std::move(next));
    }
  }
  /** Lowers each cell of `out` to the lowest of those at most `half` to its left or right. */
  void lower(float* out, std::size_t half) const
  {
    const std::size_t length = 2 * half + 1;
    std::size_t level = 0;
    while ((std::size_t{2} << level) <= length) ++level;
    const float* first = m_minima[level].data() + m_margin - half;
    lowerEach(out, first, m_width);
    lowerEach(out, first + length - (std::size_t{1} << level), m_width);
  }

 private:
  std::size_t m_width, m_margin;
  std::vector<std::vector<float>> m_minima;
};

/** Each cell becomes the lowest within the radius. */
Layer<float> erode(const Layer<float>& surface, std::int32_t radius, int threads)
{
  const grid::GridFrame& frame = surface.frame();
  const auto widths = halfWidths(radius);
  Layer<float> lowest(frame, std::numeric_limits<float>::infinity());
  const auto rows = [&](std::size_t begin, std::size_t end)
  {
    RowMinima minima(static_cast<std::size_t>(frame.width), static_cast<std::size_t>(radius));
    const auto first = static_cast<std::int32_t>(begin), last = static_cast<std::int32_t>(end);
    for (std::int32_t y = std::max(first - radius, 0); y < std::min(last + radius, frame.height);
         ++y)
    {
      minima.take(surface.row(y));
      for (std::int32_t to = std::max(y - radius, first); to < std::min(y + radius + 1, last); ++to)
        minima.lower(lowest.row(to), widths[static_cast<std::size_t>(to - y + radius)]);
    }
  };
  grid::inParallel(static_cast<std::size_t>(frame.height), threads, rows);
  return lowest;
}

void negate(Layer<float>& layer)
{
  for (float& cell : layer.cells()) cell = -cell;
}
}  // namespace

Layer<float> openWithDisc(const Layer<float>& surface, std::int32_t radius, int threads)
{
  Layer<float> lowest = erode(surface, radius, threads);
  negate(lowest);
  Layer<float> opened = erode(lowest, radius, threads);
  negate(opened);
  return opened;
}

}  // namespace mrpt_mapconv::aerial
