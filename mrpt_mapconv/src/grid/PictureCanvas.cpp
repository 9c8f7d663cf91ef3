#include "PictureCanvas.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mrpt_mapconv::grid::picture
{
namespace
{
struct FontFace
{
  const char* name;
  int width, height;
};

// MRPT's built-in bitmap fonts, which need neither files nor a display.
FontFace face(Font font)
{
  return font == Font::Title ? FontFace{"10x20", 10, 20} : FontFace{"9x15", 9, 15};
}

int characters(const std::string& utf8)
{
  const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return static_cast<int>(std::count_if(utf8.begin(), utf8.end(), starts));
}
}  // namespace

int Metrics::textWidth(const std::string& text, Font font) const
{
  return of(characters(text) * face(font).width);
}

int Metrics::textHeight(Font font) const { return of(face(font).height); }

Canvas::Canvas(int width, int height, const Metrics& metrics)
    : m_image(static_cast<unsigned>(width), static_cast<unsigned>(height)), m_metrics(metrics)
{
  m_image.filledRectangle(0, 0, width - 1, height - 1, kPaper);
}

void Canvas::text(int x, int y, const std::string& text, const TColor& color, Font font)
{
  if (text.empty()) return;
  const FontFace type = face(font);
  const int unit = m_metrics.unit();
  const int columns = characters(text) * type.width;
  // Drawn small and then enlarged: the bitmap fonts have no sizes that suit a large picture.
  mrpt::img::CImage stencil(static_cast<unsigned>(columns), static_cast<unsigned>(type.height));
  stencil.filledRectangle(0, 0, columns - 1, type.height - 1, TColor::black());
  stencil.selectTextFont(type.name);
  stencil.textOut(0, 0, text, TColor::white());
  for (int row = 0; row < type.height; ++row)
  {
    const auto* pixels = stencil.ptrLine<std::uint8_t>(static_cast<unsigned>(row));
    for (int column = 0; column < columns; ++column)
      if (pixels[3 * column] > 127) fill(x + column * unit, y + row * unit, unit, unit, color);
  }
}

void Canvas::fill(int x, int y, int width, int height, const TColor& color)
{
  if (width > 0 && height > 0) m_image.filledRectangle(x, y, x + width - 1, y + height - 1, color);
}

void Canvas::frame(int x, int y, int width, int height, const TColor& color)
{
  const int line = m_metrics.unit();
  fill(x - line, y - line, width + 2 * line, line, color);
  fill(x - line, y + height, width + 2 * line, line, color);
  fill(x - line, y, line, height, color);
  fill(x + width, y, line, height, color);
}

void Canvas::raster(int x, int y, const Raster& raster)
{
  const TColor* pixel = raster.pixels.data();
  for (int row = 0; row < raster.height; ++row)
  {
    auto* out = m_image.ptrLine<std::uint8_t>(static_cast<unsigned>(y + row)) + 3 * x;
    for (int column = 0; column < raster.width; ++column, ++pixel)
    {
      *out++ = pixel->B;
      *out++ = pixel->G;
      *out++ = pixel->R;
    }
  }
}

void Canvas::disc(int x, int y, int radius, const TColor& color)
{
  for (int dy = -radius; dy <= radius; ++dy)
  {
    const int half = static_cast<int>(std::sqrt(radius * radius - dy * dy));
    fill(x - half, y + dy, 2 * half + 1, 1, color);
  }
}

void Canvas::line(int x0, int y0, int x1, int y1, int width, const TColor& color)
{
  const int steps = std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1});
  for (int i = 0; i <= steps; ++i)
    disc(x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps, width / 2, color);
}

}  // namespace mrpt_mapconv::grid::picture
