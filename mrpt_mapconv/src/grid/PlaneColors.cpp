#include <mrpt_mapconv/grid/PlaneColors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace mrpt_mapconv::grid::picture
{
namespace
{
using mrpt::img::TColor;

/** Each as far in CIE L*a*b* from those before it as those allow, none of them grey. */
const std::array<TColor, 16> kPalette{{{0, 119, 170},
                                       {255, 204, 51},
                                       {238, 34, 102},
                                       {0, 238, 153},
                                       {187, 119, 255},
                                       {102, 119, 68},
                                       {255, 187, 221},
                                       {204, 85, 0},
                                       {0, 238, 255},
                                       {119, 170, 0},
                                       {153, 85, 85},
                                       {255, 204, 153},
                                       {170, 51, 136},
                                       {0, 136, 255},
                                       {170, 221, 170},
                                       {153, 119, 0}}};

using Pairs = std::set<std::pair<std::int32_t, std::int32_t>>;  // higher index, lower index

void addNeighbours(const Layer<float>& planes, std::int32_t x, std::int32_t y, Pairs& pairs)
{
  const GridFrame& frame = planes.frame();
  const float here = planes.at(x, y);
  const auto meet = [&](std::int32_t dx, std::int32_t dy)
  {
    if (x + dx < 0 || x + dx >= frame.width || y + dy >= frame.height) return;
    const float there = planes.at(x + dx, y + dy);
    if (std::isnan(there) || there == here) return;
    const auto [low, high] = std::minmax(here, there);
    pairs.emplace(static_cast<std::int32_t>(high), static_cast<std::int32_t>(low));
  };
  for (std::int32_t step = 1; step <= kPlaneGap; ++step)
  {
    meet(step, 0);
    meet(0, step);
    meet(step, step);
    meet(-step, step);
  }
}

Pairs neighboursOf(const Layer<float>& planes)
{
  Pairs pairs;
  const GridFrame& frame = planes.frame();
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
      if (!std::isnan(planes.at(x, y))) addNeighbours(planes, x, y, pairs);
  return pairs;
}

std::vector<bool> isThere(const Layer<float>& planes)
{
  std::vector<bool> there;
  for (const float plane : planes.cells())
  {
    if (std::isnan(plane)) continue;
    const auto index = static_cast<std::size_t>(plane);
    if (index >= there.size()) there.resize(index + 1);
    there[index] = true;
  }
  return there;
}
}  // namespace

/** Each plane takes the first colour, counted from its index, that no lower neighbour has. A plane
 * with more neighbours than there are colours may share one with some of them. */
PlaneColors::PlaneColors(const Layer<float>& planes)
{
  const std::vector<bool> there = isThere(planes);
  m_planes = static_cast<std::size_t>(std::count(there.begin(), there.end(), true));
  const Pairs pairs = neighboursOf(planes);
  auto pair = pairs.begin();
  for (std::size_t plane = 0; plane < there.size(); ++plane)
  {
    std::array<bool, kPalette.size()> isTaken{};
    for (; pair != pairs.end() && static_cast<std::size_t>(pair->first) == plane; ++pair)
      isTaken[m_colors[static_cast<std::size_t>(pair->second)]] = true;
    std::size_t color = plane % kPalette.size();
    for (std::size_t tried = 1; tried < kPalette.size() && isTaken[color]; ++tried)
      color = (color + 1) % kPalette.size();
    m_colors.push_back(color);
  }
}

const TColor& PlaneColors::of(std::int32_t plane) const
{
  return kPalette[m_colors.at(static_cast<std::size_t>(plane))];
}

TColor bareColor(double t)
{
  const auto level = static_cast<std::uint8_t>(std::lround(90 + 100 * std::clamp(t, 0.0, 1.0)));
  return {level, level, level};
}

}  // namespace mrpt_mapconv::grid::picture
