#include "PlanePicture.h"

#include <mrpt_mapconv/grid/PlaneColors.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::grid::picture
{
namespace
{
constexpr double kLeastOutlined = 4;  // pixels

bool hasData(const Layer<float>& layer)
{
  return std::any_of(layer.cells().begin(), layer.cells().end(),
                     [](float value) { return std::isfinite(value); });
}

/** Where cells lie in a raster, whose first row is the highest. */
struct Pixels
{
  const GridFrame& frame;
  const Zoom& zoom;
  Raster& raster;

  int left(std::int32_t x) const { return x / zoom.reduce * zoom.enlarge; }
  int bottom(std::int32_t y) const { return raster.height - 1 - y / zoom.reduce * zoom.enlarge; }
  int right(std::int32_t x) const { return left(x) + zoom.enlarge - 1; }
  int top(std::int32_t y) const { return bottom(y) - zoom.enlarge + 1; }
};

/** Darkens the pixels on squares' edges, each once. */
class Outlines
{
 public:
  Outlines(const Layer<float>& squares, const Zoom& zoom, Raster& raster)
      : m_squares(squares),
        m_zoom(zoom),
        m_pixels{squares.frame(), zoom, raster},
        m_isEdge(raster.pixels.size())
  {
  }

  /** \return whether there are any */
  bool draw()
  {
    const GridFrame& frame = m_squares.frame();
    for (std::int32_t y = 0; y < frame.height; ++y)
      for (std::int32_t x = 0; x < frame.width; ++x) outline(x, y);
    for (std::size_t i = 0; i < m_isEdge.size(); ++i)
      if (m_isEdge[i]) m_pixels.raster.pixels[i] = darker(m_pixels.raster.pixels[i]);
    return std::count(m_isEdge.begin(), m_isEdge.end(), true) > 0;
  }

 private:
  static TColor darker(const TColor& color)
  {
    const auto dim = [](std::uint8_t c) { return static_cast<std::uint8_t>(0.45 * c); };
    return {dim(color.R), dim(color.G), dim(color.B)};
  }

  bool isKnown(std::int32_t x, std::int32_t y) const
  {
    const GridFrame& frame = m_squares.frame();
    return x < frame.width && y < frame.height && std::isfinite(m_squares.at(x, y));
  }

  /** The edges of a cell that are its square's: those on the left and below, and those behind
   * which nothing is known. */
  void outline(std::int32_t x, std::int32_t y)
  {
    if (!isKnown(x, y)) return;
    const GridFrame& frame = m_squares.frame();
    const auto side = static_cast<std::int32_t>(
        std::lround(static_cast<double>(m_squares.at(x, y)) / frame.resolution));
    if (side < 1 || side * m_zoom.pixelsPerCell() < kLeastOutlined) return;
    const int left = m_pixels.left(x), right = m_pixels.right(x);
    const int top = m_pixels.top(y), bottom = m_pixels.bottom(y);
    if ((frame.x0 + x) % side == 0) mark(left, left, top, bottom);
    if ((frame.y0 + y) % side == 0) mark(left, right, bottom, bottom);
    if (!isKnown(x + 1, y)) mark(right, right, top, bottom);
    if (!isKnown(x, y + 1)) mark(left, right, top, top);
  }

  void mark(int x0, int x1, int y0, int y1)
  {
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        m_isEdge[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_pixels.raster.width) +
                 static_cast<std::size_t>(x)] = true;
  }

  const Layer<float>& m_squares;
  const Zoom& m_zoom;
  Pixels m_pixels;
  std::vector<bool> m_isEdge;
};

std::vector<LegendItem> legendOf(const StyledLayer& styled, const PlaneColors& colors,
                                 bool hasOutlines, const Metrics& metrics)
{
  std::vector<TColor> some;
  for (const float plane : styled.layer->cells())
  {
    if (some.size() == 5) break;
    if (std::isnan(plane)) continue;
    const TColor& color = colors.of(static_cast<std::int32_t>(plane));
    if (std::find(some.begin(), some.end(), color) == some.end()) some.push_back(color);
  }
  std::vector<LegendItem> items;
  if (!some.empty())
    items.push_back(swatches(
        metrics, some,
        params::counted(colors.planes(), "plane") + ": colours only tell neighbours apart"));
  if (styled.shade)
    items.push_back(swatches(metrics, {bareColor(0), bareColor(0.5), bareColor(1)},
                             "no plane: a height of its own, low to high"));
  items.push_back(swatch(metrics, kNoDataColor, styled.shade ? "unknown" : "no plane, or unknown"));
  if (hasOutlines)
    items.push_back(note(metrics, "lines around squares of cells that are stored as one"));
  return items;
}
}  // namespace

PlanePicture drawPlanes(const StyledLayer& styled, const Zoom& zoom, const Metrics& metrics)
{
  const PlaneColors colors(*styled.layer);
  PlanePicture picture;
  picture.raster = rasterOfPlanes(styled, colors,
                                  styled.shade ? heightRange(*styled.shade) : ColorRange(), zoom);
  const bool hasOutlines = styled.squares && Outlines(*styled.squares, zoom, picture.raster).draw();
  picture.legend = legendOf(styled, colors, hasOutlines, metrics);
  picture.noData = !hasData(*styled.layer) && !(styled.shade && hasData(*styled.shade));
  return picture;
}

}  // namespace mrpt_mapconv::grid::picture
