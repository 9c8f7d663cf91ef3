#include "SlopeSmoothing.h"

#include <algorithm>
#include <cmath>

#include "EmptyCells.h"

namespace mrpt_mapconv::aerial
{
namespace
{
struct Offset
{
  std::int32_t dx, dy;
};

std::vector<Offset> offsetsWithin(double cells)
{
  std::vector<Offset> offsets;
  const auto reach = static_cast<std::int32_t>(cells);
  for (std::int32_t dy = -reach; dy <= reach; ++dy)
    for (std::int32_t dx = -reach; dx <= reach; ++dx)
      if (dx * dx + dy * dy <= cells * cells && (dx != 0 || dy != 0)) offsets.push_back({dx, dy});
  return offsets;
}

/** What was measured where, as the cloth has it before any of it is moved. */
class Gaps
{
 public:
  Gaps(const Cloth& cloth, const grid::Layer<float>& measured, double slope, int threads)
      : m_width(static_cast<std::uint32_t>(measured.frame().width)),
        m_cellRise(static_cast<float>(slope * measured.frame().resolution)),
        m_source(nearestMeasured(measured, threads)),
        m_gap(m_source.size())
  {
    for (std::size_t i = 0; i < m_gap.size(); ++i) m_gap[i] = cloth.gap(i);
  }

  bool isMeasured(std::uint32_t cell) const { return m_source[cell] == cell; }
  /** Whether both are on one ground, as seen from the cloth. */
  bool areJoined(std::uint32_t a, std::uint32_t b) const
  {
    const std::uint32_t p = m_source[a], q = m_source[b];
    const float dx = static_cast<float>(p % m_width) - static_cast<float>(q % m_width);
    const float dy = static_cast<float>(p / m_width) - static_cast<float>(q / m_width);
    return std::abs(m_gap[p] - m_gap[q]) <= m_cellRise * std::sqrt(dx * dx + dy * dy);
  }

 private:
  std::uint32_t m_width;
  float m_cellRise;                     // allowed for a distance of one cell [m]
  std::vector<std::uint32_t> m_source;  // of each cell
  std::vector<float> m_gap;             // [m]
};
}  // namespace

void drawOn(Cloth& cloth, const grid::Layer<float>& measured, const GroundParams& params,
            int threads)
{
  const grid::GridFrame& frame = measured.frame();
  const Gaps gaps(cloth, measured, params.smoothingSlope, threads);
  const auto offsets = offsetsWithin(std::max(params.smoothingReach / frame.resolution, 1.0));
  std::vector<std::uint32_t> open;
  std::vector<bool> reached(frame.size());
  const auto reach = [&](std::uint32_t cell)
  {
    reached[cell] = true;
    open.push_back(cell);
  };
  for (std::uint32_t cell = 0; cell < frame.size(); ++cell)
    if (cloth.isFixed(cell)) reach(cell);
  const auto width = static_cast<std::uint32_t>(frame.width);
  while (!open.empty())
  {
    const std::uint32_t cell = open.back();
    open.pop_back();
    for (const auto& [dx, dy] : offsets)
    {
      const std::int32_t kx = frame.x0 + static_cast<std::int32_t>(cell % width) + dx;
      const std::int32_t ky = frame.y0 + static_cast<std::int32_t>(cell / width) + dy;
      if (!frame.containsKey(kx, ky)) continue;
      const auto next = static_cast<std::uint32_t>(frame.indexOfKey(kx, ky));
      if (reached[next] || !gaps.areJoined(cell, next)) continue;
      if (gaps.isMeasured(next)) cloth.fix(next);
      reach(next);
    }
  }
}

}  // namespace mrpt_mapconv::aerial
