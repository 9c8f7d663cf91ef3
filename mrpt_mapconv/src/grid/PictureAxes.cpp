#include "PictureAxes.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::grid::picture
{
namespace
{
constexpr int kTick = 6, kGap = 5;
const char* const kXName = "x [m]";
const char* const kYName = "y [m]";

int widest(const Metrics& metrics, const std::vector<Tick>& ticks)
{
  int width = 0;
  for (const Tick& tick : ticks) width = std::max(width, metrics.textWidth(tick.label));
  return width;
}
/** Ticks so far apart, or a single one if the map is too small for that. */
std::vector<Tick> ticksOrOne(double min, double max, double leastStep)
{
  std::vector<Tick> out = ticks(min, max, leastStep);
  if (!out.empty()) return out;
  for (double step = leastStep; out.empty(); step /= 2) out = ticks(min, max, step);
  out.resize(1);
  return out;
}
}  // namespace

Axes::Axes(const Metrics& metrics, const GridFrame& frame, double pixelsPerCell)
    : m_frame(frame), m_pixelsPerMetre(pixelsPerCell / frame.resolution)
{
  m_yTicks = ticksOrOne(frame.yMin(), frame.yMax(), metrics.of(55) / m_pixelsPerMetre);
  m_xTicks = ticksOrOne(frame.xMin(), frame.xMax(), metrics.of(90) / m_pixelsPerMetre);
  // Long numbers need their ticks farther apart.
  const int room = widest(metrics, m_xTicks) + metrics.of(30);
  if (room > metrics.of(90))
    m_xTicks = ticksOrOne(frame.xMin(), frame.xMax(), room / m_pixelsPerMetre);
  const int widestX = widest(metrics, m_xTicks);
  m_left = std::max({widest(metrics, m_yTicks) + metrics.of(kTick + kGap),
                     metrics.textWidth(kYName) / 2, widestX / 2});
  m_right = widestX / 2 + metrics.of(2 * kGap) + metrics.textWidth(kXName);
  m_bottom = metrics.of(kTick + kGap) + metrics.textHeight();
}

void Axes::draw(Canvas& canvas, int x, int y, int width, int height) const
{
  const Metrics& m = canvas.metrics();
  const int line = m.unit(), tick = m.of(kTick), gap = m.of(kGap);
  canvas.frame(x, y, width, height, kFaintInk);
  const int labelY = y + height + tick + gap;
  for (const Tick& t : m_xTicks)
  {
    const int at = x + static_cast<int>(std::lround((t.value - m_frame.xMin()) * m_pixelsPerMetre));
    canvas.fill(at, y + height, line, tick, kFaintInk);
    canvas.text(at - m.textWidth(t.label) / 2, labelY, t.label, kInk);
  }
  for (const Tick& t : m_yTicks)
  {
    const int at = y + static_cast<int>(std::lround((m_frame.yMax() - t.value) * m_pixelsPerMetre));
    canvas.fill(x - tick, at, tick, line, kFaintInk);
    canvas.text(x - tick - gap - m.textWidth(t.label), at - m.textHeight() / 2, t.label, kInk);
  }
  // The names stand where no tick label can: right of the last and above the first.
  canvas.text(x + width + m_right - m.textWidth(kXName), labelY, kXName, kFaintInk);
  canvas.text(std::max(0, x - m.textWidth(kYName) / 2), y - m.textHeight() * 3 / 2 - gap - line,
              kYName, kFaintInk);
}

}  // namespace mrpt_mapconv::grid::picture
