#include "PictureLegend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "PictureTicks.h"

namespace mrpt_mapconv::grid::picture
{
namespace
{
constexpr int kGap = 8;       // between a box and its text
constexpr int kItemGap = 26;  // between items

/** Decimals that show about three digits of a span. */
int decimalsForSpan(double span)
{
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(span) + 1e-9)), 0, 4);
}
}  // namespace

LegendItem swatch(const Metrics& metrics, const TColor& color, const std::string& meaning)
{
  return swatches(metrics, {color}, meaning);
}

LegendItem swatches(const Metrics& metrics, const std::vector<TColor>& colors,
                    const std::string& meaning)
{
  const int side = metrics.textHeight(), boxes = side * static_cast<int>(colors.size());
  const int gap = metrics.of(kGap), margin = metrics.unit();
  return {boxes + 2 * margin + gap + metrics.textWidth(meaning), side + 2 * margin,
          [=](Canvas& canvas, int x, int y)
          {
            for (std::size_t i = 0; i < colors.size(); ++i)
              canvas.fill(x + margin + side * static_cast<int>(i), y + margin, side, side,
                          colors[i]);
            canvas.frame(x + margin, y + margin, boxes, side, kFaintInk);
            canvas.text(x + boxes + 2 * margin + gap, y + margin, meaning, kInk);
          }};
}

LegendItem colorBar(const Metrics& metrics, const ColorRange& range, const std::string& unit,
                    TColor (*colorOf)(double))
{
  const int decimals = decimalsForSpan(range.high - range.low);
  const std::string low = (range.clippedLow() ? "<= " : "") + number(range.low, decimals);
  const std::string middle = number((range.low + range.high) / 2, decimals);
  const std::string high = (range.clippedHigh() ? ">= " : "") + number(range.high, decimals);
  const int margin = metrics.unit(), gap = metrics.of(kGap), thickness = metrics.of(18);
  const int length = std::max(metrics.of(300), metrics.textWidth(low) + metrics.textWidth(middle) +
                                                   metrics.textWidth(high) + 4 * gap);
  const int labelY = thickness + 2 * margin + gap / 2;
  return {length + 2 * margin + gap + metrics.textWidth(unit), labelY + metrics.textHeight(),
          [=](Canvas& canvas, int x, int y)
          {
            const Metrics& m = canvas.metrics();
            const int left = x + margin, top = y + margin;
            for (int i = 0; i < length; ++i)
              canvas.fill(left + i, top, 1, thickness,
                          colorOf(static_cast<double>(i) / (length - 1)));
            canvas.frame(left, top, length, thickness, kFaintInk);
            canvas.text(left + length + gap, top + (thickness - m.textHeight()) / 2, unit, kInk);
            canvas.text(left, y + labelY, low, kInk);
            canvas.text(left + (length - m.textWidth(middle)) / 2, y + labelY, middle, kInk);
            canvas.text(left + length - m.textWidth(high), y + labelY, high, kInk);
          }};
}

LegendItem note(const Metrics& metrics, const std::string& text)
{
  return {metrics.textWidth(text), metrics.textHeight(),
          [=](Canvas& canvas, int x, int y) { canvas.text(x, y, text, kFaintInk); }};
}

LegendItem scaleBar(const Metrics& metrics, double pixelsPerMetre, int longest)
{
  const double most = longest / pixelsPerMetre;
  // The largest round length that fits: the next round step above a fifth … half of it.
  double length = roundStep(most / 5);
  while (roundStep(length * 1.01) <= most) length = roundStep(length * 1.01);
  const int pixels = std::max(1, static_cast<int>(std::lround(length * pixelsPerMetre)));
  const std::string label = number(length, decimalsOf(length)) + " m";
  const int thickness = metrics.of(5), textHeight = metrics.textHeight(), gap = metrics.of(kGap);
  return {pixels + gap + metrics.textWidth(label), textHeight,
          [=](Canvas& canvas, int x, int y)
          {
            const int half = pixels / 2, top = y + (textHeight - thickness) / 2;
            canvas.fill(x, top, pixels, thickness, kInk);
            const int line = canvas.metrics().unit();
            canvas.fill(x + half, top + line, pixels - half - line, thickness - 2 * line, kPaper);
            canvas.text(x + pixels + gap, y, label, kInk);
          }};
}

Legend::Legend(const Metrics& metrics, std::vector<LegendItem> items, int width)
    : m_items(std::move(items))
{
  const int gap = metrics.of(kItemGap), rowGap = metrics.of(12);
  int x = 0, y = 0, rowHeight = 0;
  for (const LegendItem& item : m_items)
  {
    if (x > 0 && x + item.width > width)
    {
      x = 0;
      y += rowHeight + rowGap;
      rowHeight = 0;
    }
    m_places.push_back({x, y});
    x += item.width + gap;
    rowHeight = std::max(rowHeight, item.height);
  }
  m_height = y + rowHeight;
}

void Legend::draw(Canvas& canvas, int x, int y) const
{
  for (std::size_t i = 0; i < m_items.size(); ++i)
    m_items[i].draw(canvas, x + m_places[i].x, y + m_places[i].y);
}

}  // namespace mrpt_mapconv::grid::picture
