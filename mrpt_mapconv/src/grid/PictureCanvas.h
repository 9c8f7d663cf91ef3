#pragma once

#include <mrpt/img/CImage.h>

#include <string>

#include "PictureRaster.h"

namespace mrpt_mapconv::grid::picture
{
enum class Font
{
  Label,
  Title
};

/** Sizes of a picture's parts in pixels. All lengths are multiples of one unit, so that text stays
 * readable when a large picture is looked at as a whole. */
class Metrics
{
 public:
  explicit Metrics(int unit) : m_unit(unit) {}

  int unit() const { return m_unit; }
  int of(int length) const { return length * m_unit; }  //!< a length given for unit 1
  int textWidth(const std::string& text, Font font = Font::Label) const;
  int textHeight(Font font = Font::Label) const;

 private:
  int m_unit;
};

/** A thin layer over MRPT's CImage: text of any whole size, fills, a raster. */
class Canvas
{
 public:
  /** All paper. */
  Canvas(int width, int height, const Metrics& metrics);

  const Metrics& metrics() const { return m_metrics; }
  const mrpt::img::CImage& image() const { return m_image; }
  int width() const { return static_cast<int>(m_image.getWidth()); }

  /** Text with its upper left corner at (x, y). */
  void text(int x, int y, const std::string& text, const TColor& color, Font font = Font::Label);
  /** Fills width × height pixels from the upper left corner (x, y). */
  void fill(int x, int y, int width, int height, const TColor& color);
  /** A frame of one unit around the width × height pixels from (x, y), outside of them. */
  void frame(int x, int y, int width, int height, const TColor& color);
  void raster(int x, int y, const Raster& raster);
  /** A disc of `radius` pixels. */
  void disc(int x, int y, int radius, const TColor& color);
  /** A line of `width` pixels with round ends. */
  void line(int x0, int y0, int x1, int y1, int width, const TColor& color);

 private:
  mrpt::img::CImage m_image;
  Metrics m_metrics;
};

}  // namespace mrpt_mapconv::grid::picture
