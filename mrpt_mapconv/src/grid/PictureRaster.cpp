#include "PictureRaster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "OccupancyLook.h"

namespace mrpt_mapconv::grid::picture
{
namespace
{
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

int ceilDiv(int a, int b) { return (a + b - 1) / b; }

/** Builds a raster from `colorOf(x0, x1, y0, y1)`: the colour of a block of cells. */
template <class ColorOf>
Raster rasterize(const GridFrame& frame, const Zoom& zoom, ColorOf colorOf)
{
  const int columns = ceilDiv(frame.width, zoom.reduce);
  const int rows = ceilDiv(frame.height, zoom.reduce);
  Raster out{columns * zoom.enlarge, rows * zoom.enlarge, {}};
  out.pixels.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  std::vector<TColor> line(static_cast<std::size_t>(out.width));
  for (int r = rows - 1; r >= 0; --r)
  {
    const int y0 = r * zoom.reduce, y1 = std::min(y0 + zoom.reduce, frame.height);
    for (int c = 0; c < columns; ++c)
    {
      const int x0 = c * zoom.reduce, x1 = std::min(x0 + zoom.reduce, frame.width);
      std::fill_n(line.begin() + c * zoom.enlarge, zoom.enlarge, colorOf(x0, x1, y0, y1));
    }
    for (int i = 0; i < zoom.enlarge; ++i)
      out.pixels.insert(out.pixels.end(), line.begin(), line.end());
  }
  return out;
}
}  // namespace

double meanOf(const Layer<float>& layer, int x0, int x1, int y0, int y1)
{
  double sum = 0;
  int count = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      if (const float value = layer.at(x, y); std::isfinite(value))
      {
        sum += static_cast<double>(value);
        ++count;
      }
  return sum / count;  // 0 / 0 is NaN
}

Zoom zoomFor(const GridFrame& frame)
{
  constexpr int kLeast = 800, kMost = 2400;
  const int side = std::max(frame.width, frame.height);
  if (side > kMost) return {1, ceilDiv(side, kMost)};
  return {ceilDiv(kLeast, side), 1};
}

Raster rasterOfHeights(const Layer<float>& layer, const ColorRange& range, const Zoom& zoom)
{
  return rasterize(layer.frame(), zoom,
                   [&](int x0, int x1, int y0, int y1)
                   {
                     const double mean = meanOf(layer, x0, x1, y0, y1);
                     return std::isfinite(mean) ? heightColor(range.position(mean)) : kNoDataColor;
                   });
}

Raster rasterOfSlopes(const Layer<float>& layer, const ColorRange& range, const Zoom& zoom)
{
  return rasterize(layer.frame(), zoom,
                   [&](int x0, int x1, int y0, int y1)
                   {
                     float largest = -std::numeric_limits<float>::infinity();
                     for (int y = y0; y < y1; ++y)
                       for (int x = x0; x < x1; ++x)
                         if (const float value = layer.at(x, y); std::isfinite(value))
                           largest = std::max(largest, value);
                     return std::isfinite(largest)
                                ? slopeColor(range.position(static_cast<double>(largest)))
                                : kNoDataColor;
                   });
}

Raster rasterOfOccupancy(const StyledLayer& styled, const Zoom& zoom)
{
  return rasterize(styled.layer->frame(), zoom,
                   [&](int x0, int x1, int y0, int y1)
                   {
                     auto look = OccupancyLook::Unknown;
                     for (int y = y0; y < y1; ++y)
                       for (int x = x0; x < x1; ++x) look = std::max(look, lookOf(styled, x, y));
                     return colorOf(look);
                   });
}

Raster rasterOfEvidence(const Layer<float>& layer, const Zoom& zoom)
{
  return rasterize(
      layer.frame(), zoom,
      [&](int x0, int x1, int y0, int y1)
      {
        float most = 0;
        for (int y = y0; y < y1; ++y)
          for (int x = x0; x < x1; ++x) most = std::max(most, layer.at(x, y));
        const auto last = static_cast<float>(kEvidenceLooks.size() - 1);
        return kEvidenceLooks[static_cast<std::size_t>(std::clamp(most, 0.0f, last))].color;
      });
}

Raster rasterOfPlanes(const StyledLayer& styled, const PlaneColors& colors, const ColorRange& bare,
                      const Zoom& zoom)
{
  return rasterize(styled.layer->frame(), zoom,
                   [&](int x0, int x1, int y0, int y1)
                   {
                     for (int y = y0; y < y1; ++y)
                       for (int x = x0; x < x1; ++x)
                         if (const float plane = styled.layer->at(x, y); !std::isnan(plane))
                           return colors.of(static_cast<std::int32_t>(plane));
                     const double mean =
                         styled.shade ? meanOf(*styled.shade, x0, x1, y0, y1) : kNone;
                     return std::isfinite(mean) ? bareColor(bare.position(mean)) : kNoDataColor;
                   });
}

}  // namespace mrpt_mapconv::grid::picture
