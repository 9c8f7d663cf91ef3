#pragma once

#include <functional>
#include <string>
#include <vector>

#include "PictureCanvas.h"

namespace mrpt_mapconv::grid::picture
{
/** One thing in a legend: its size in pixels and how to draw it with its upper left at (x, y). */
struct LegendItem
{
  int width = 0, height = 0;
  std::function<void(Canvas&, int x, int y)> draw;
};

/** A small box of a colour with its meaning. */
LegendItem swatch(const Metrics& metrics, const TColor& color, const std::string& meaning);
/** Small boxes side by side, of colours that have one meaning. */
LegendItem swatches(const Metrics& metrics, const std::vector<TColor>& colors,
                    const std::string& meaning);
/** A colour bar with the values at its ends and middle; "<=" and ">=" mark clipped ends. */
LegendItem colorBar(const Metrics& metrics, const ColorRange& range, const std::string& unit,
                    TColor (*colorOf)(double));
/** A line of text in fainter ink. */
LegendItem note(const Metrics& metrics, const std::string& text);
/** A bar of a round length in metres.
 * \param pixelsPerMetre of the map
 * \param longest the bar may become, in pixels */
LegendItem scaleBar(const Metrics& metrics, double pixelsPerMetre, int longest);

/** Items set side by side into rows that are at most `width` wide. */
class Legend
{
 public:
  Legend(const Metrics& metrics, std::vector<LegendItem> items, int width);
  int height() const { return m_height; }
  void draw(Canvas& canvas, int x, int y) const;

 private:
  struct Place
  {
    int x, y;
  };
  std::vector<LegendItem> m_items;
  std::vector<Place> m_places;
  int m_height = 0;
};

}  // namespace mrpt_mapconv::grid::picture
