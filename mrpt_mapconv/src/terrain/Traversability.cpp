#include "Traversability.h"

#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "DropEdges.h"

namespace mrpt_mapconv::terrain
{
namespace
{

/** Lowest and highest of some heights. */
struct HeightRange
{
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();

  void take(const HeightRange& o)
  {
    low = std::min(low, o.low);
    high = std::max(high, o.high);
  }
  double size() const { return static_cast<double>(high) - static_cast<double>(low); }
};

/** Has each value take those up to `radius` away, in time that does not grow with the radius:
 * blocks are taken from either side (van Herk 1992). */
class Slide
{
 public:
  explicit Slide(std::size_t radius) : m_radius(radius) {}

  /** \param stride from one value of the line to the next */
  void run(HeightRange* line, std::size_t count, std::size_t stride)
  {
    const std::size_t block = 2 * m_radius + 1, padded = count + 2 * m_radius;
    m_left.assign(padded, {});
    for (std::size_t i = 0; i < count; ++i) m_left[i + m_radius] = line[i * stride];
    m_right = m_left;
    for (std::size_t i = 1; i < padded; ++i)
      if (i % block != 0) m_left[i].take(m_left[i - 1]);
    for (std::size_t i = padded - 1; i > 0; --i)
      if (i % block != 0) m_right[i - 1].take(m_right[i]);
    for (std::size_t i = 0; i < count; ++i)
    {
      line[i * stride] = m_right[i];
      line[i * stride].take(m_left[i + 2 * m_radius]);
    }
  }

 private:
  std::size_t m_radius;
  std::vector<HeightRange> m_left, m_right;
};

/** Lowest and highest height of each cell and those around it, up to a number of cells away. */
std::vector<HeightRange> rangesAround(const grid::Layer<float>& height, std::size_t radius)
{
  const auto width = static_cast<std::size_t>(height.frame().width),
             rows = static_cast<std::size_t>(height.frame().height);
  std::vector<HeightRange> ranges(width * rows);
  for (std::size_t i = 0; i < ranges.size(); ++i)
    if (const float h = height.cells()[i]; !std::isnan(h)) ranges[i] = {h, h};
  Slide slide(radius);
  for (std::size_t y = 0; y < rows; ++y) slide.run(&ranges[y * width], width, 1);
  for (std::size_t x = 0; x < width; ++x) slide.run(&ranges[x], rows, width);
  return ranges;
}

/** Whether one of a cell's 8 neighbours is more than maxStep higher or lower. */
bool isStep(const grid::Layer<float>& height, std::int32_t x, std::int32_t y, double maxStep)
{
  const grid::GridFrame& frame = height.frame();
  const auto own = static_cast<double>(height.at(x, y));
  for (std::int32_t ny = std::max(0, y - 1); ny <= std::min(frame.height - 1, y + 1); ++ny)
    for (std::int32_t nx = std::max(0, x - 1); nx <= std::min(frame.width - 1, x + 1); ++nx)
      if (std::fabs(static_cast<double>(height.at(nx, ny)) - own) > maxStep) return true;
  return false;
}
}  // namespace

grid::Layer<float> traversabilityOf(const TerrainLayers& layers, const TerrainParams& params)
{
  const grid::GridFrame& frame = layers.height.frame();
  grid::Layer<float> out(frame, grid::kUnknown);
  if (frame.empty()) return out;
  const auto radius = static_cast<std::size_t>(std::max(1.0, std::ceil(kEdge / frame.resolution)));
  const auto around = rangesAround(layers.height, radius);
  const auto atDrop = dropEdges(layers, params.maxStep, params.maxSlope);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      if (std::isnan(layers.height.at(x, y))) continue;
      const auto slope = static_cast<double>(layers.slope.at(x, y));
      const std::size_t at = frame.indexOfKey(frame.x0 + x, frame.y0 + y);
      const bool isUneven = around[at].size() > params.maxStep;  // its neighbours are among those
      const bool isEdge = isUneven && std::isnan(slope);
      const bool isOccupied = isEdge || atDrop[at] || slope > params.maxSlope ||
                              (isUneven && isStep(layers.height, x, y, params.maxStep));
      out.at(x, y) = isOccupied ? 1.0f : grid::kFree;
    }
  return out;
}

}  // namespace mrpt_mapconv::terrain
