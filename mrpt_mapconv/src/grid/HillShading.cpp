#include "HillShading.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::grid::picture
{
namespace
{
/** Of the cells that share a pixel, the mean height: what their colour shows. */
class PixelHeights
{
 public:
  PixelHeights(const Layer<float>& heights, const Zoom& zoom)
      : m_heights(heights), m_zoom(zoom), m_step(heights.frame().resolution * zoom.reduce)
  {
  }

  double step() const { return m_step; }  //!< between neighbours [m]
  int columns() const { return ceilDiv(m_heights.frame().width); }
  int rows() const { return ceilDiv(m_heights.frame().height); }
  /** From the lower left corner on; as of the nearest beyond the border. NaN: none. */
  double at(int column, int row) const
  {
    column = std::clamp(column, 0, columns() - 1);
    row = std::clamp(row, 0, rows() - 1);
    const int x = column * m_zoom.reduce, y = row * m_zoom.reduce;
    return meanOf(m_heights, x, std::min(x + m_zoom.reduce, m_heights.frame().width), y,
                  std::min(y + m_zoom.reduce, m_heights.frame().height));
  }

 private:
  int ceilDiv(int cells) const { return (cells + m_zoom.reduce - 1) / m_zoom.reduce; }

  const Layer<float>& m_heights;
  const Zoom& m_zoom;
  double m_step;
};

/** How bright a surface is of that rise to the east and north [m/m], level ones being 1. */
double brightness(double east, double north)
{
  // towards the light: (−1, 1, √2)/2; the surface's normal: (−east, −north, 1)
  const double facing = (east - north + std::sqrt(2.0)) / 2 / std::hypot(east, north, 1);
  return std::max(0.0, facing) * std::sqrt(2.0);
}

TColor lit(const TColor& color, double brightness)
{
  constexpr double kAmbient = 0.35;  // of the light comes from all sides
  const double factor = kAmbient + (1 - kAmbient) * brightness;
  const auto scale = [factor](std::uint8_t c)
  { return static_cast<std::uint8_t>(std::min(255.0, std::round(factor * c))); };
  return {scale(color.R), scale(color.G), scale(color.B)};
}
}  // namespace

void shadeHills(const Layer<float>& layer, const Zoom& zoom, Raster& raster)
{
  const PixelHeights heights(layer, zoom);
  for (int row = 0; row < heights.rows(); ++row)
    for (int column = 0; column < heights.columns(); ++column)
    {
      const double span = 2 * heights.step();
      const double east = (heights.at(column + 1, row) - heights.at(column - 1, row)) / span;
      const double north = (heights.at(column, row + 1) - heights.at(column, row - 1)) / span;
      if (!std::isfinite(east + north + heights.at(column, row))) continue;
      const double light = brightness(east, north);
      for (int v = 0; v < zoom.enlarge; ++v)
        for (int u = 0; u < zoom.enlarge; ++u)
        {
          const auto at = static_cast<std::size_t>(raster.height - 1 - row * zoom.enlarge - v) *
                              static_cast<std::size_t>(raster.width) +
                          static_cast<std::size_t>(column * zoom.enlarge + u);
          raster.pixels[at] = lit(raster.pixels[at], light);
        }
    }
}

}  // namespace mrpt_mapconv::grid::picture
