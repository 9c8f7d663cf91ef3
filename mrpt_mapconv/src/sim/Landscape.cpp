#include "Landscape.h"

#include <algorithm>
#include <cmath>

#include "Noise.h"

namespace mrpt_mapconv::sim
{
namespace
{
constexpr double kSteepness = 0.04;  // height difference per side length: 8 m on 200 m
constexpr double kHighestRelief = 8.0;
constexpr double kRoomAbove = 15.0;  // above the highest ground: what a scanner reaches, trees
constexpr double kLeastSeen = 3.0, kMostSeen = 12.0;
constexpr std::uint64_t kStonesEvery = 7;  // every so many cells the ground is one voxel higher
constexpr std::int32_t kRagged = 7;        // how much the ends of neighbouring rays differ [voxels]
constexpr std::int32_t kMissedEvery = 12;  // every so many columns one voxel was missed

std::int32_t toCells(double metres, double resolution)
{
  return std::max(1, static_cast<std::int32_t>(std::lround(metres / resolution)));
}

Area centredSquare(std::int32_t side)
{
  return {-side / 2, -side / 2, side - side / 2 - 1, side - side / 2 - 1};
}
}  // namespace

Landscape::Landscape(const OutdoorOptions& options)
    : m_resolution(options.resolution),
      m_area(centredSquare(toCells(options.size, options.resolution))),
      m_relief(toCells(std::min(kHighestRelief, kSteepness * options.size), options.resolution)),
      m_canvas({{m_area.x0, m_area.y0, -2},
                {m_area.x1, m_area.y1, m_relief + toCells(kRoomAbove, options.resolution)}})
{
  makeGround(options);
  paintGroundAndAir(options);
}

std::int32_t Landscape::cells(double metres) const { return toCells(metres, m_resolution); }

void Landscape::makeGround(const OutdoorOptions& options)
{
  const ValueNoise hills(options.seed, cells(60)), knolls(options.seed + 1, cells(22)),
      bumps(options.seed + 2, cells(5));
  std::vector<std::int64_t> raw;
  for (std::int32_t y = m_area.y0; y <= m_area.y1; ++y)
    for (std::int32_t x = m_area.x0; x <= m_area.x1; ++x)
      raw.push_back(20 * hills(x, y) + 6 * knolls(x, y) + bumps(x, y));

  const auto [lowest, highest] = std::minmax_element(raw.begin(), raw.end());
  const std::int64_t low = *lowest, range = std::max<std::int64_t>(1, *highest - low);
  std::uint64_t stones = mixBits(options.seed + 6);
  for (const std::int64_t r : raw)
  {
    stones = mixBits(stones);
    m_ground.push_back(static_cast<std::int32_t>((r - low) * m_relief / range) +
                       (stones % kStonesEvery == 0));
  }
}

void Landscape::paintGroundAndAir(const OutdoorOptions& options)
{
  const std::int32_t least = cells(kLeastSeen), more = cells(kMostSeen) - least;
  const ValueNoise reach(options.seed + 3, cells(14)), rays(options.seed + 4, cells(0.8));
  for (std::int32_t y = m_area.y0; y <= m_area.y1; ++y)
    for (std::int32_t x = m_area.x0; x <= m_area.x1; ++x)
    {
      const std::int32_t floor = ground(x, y);
      const std::int64_t share = (6 * reach(x, y) + rays(x, y)) / 7;
      Dice dice(hashAt(options.seed + 5, x, y));
      const auto seen =
          static_cast<std::int32_t>(least + more * share / ValueNoise::kOne) + dice(0, kRagged);
      m_canvas.fillColumn(x, y, m_canvas.box().min[2], floor, State::Occupied);
      m_canvas.fillColumn(x, y, floor, floor + seen, State::Free);
      // high up, the rays are so sparse that they miss voxels
      if (dice(1, kMissedEvery) == 1) m_canvas.set(x, y, floor + dice(least, seen), State::Unknown);
    }
}

std::int32_t Landscape::ground(std::int32_t x, std::int32_t y) const
{
  const auto ix = static_cast<std::size_t>(std::clamp(x, m_area.x0, m_area.x1) - m_area.x0);
  const auto iy = static_cast<std::size_t>(std::clamp(y, m_area.y0, m_area.y1) - m_area.y0);
  return m_ground[iy * static_cast<std::size_t>(m_area.x1 - m_area.x0 + 1) + ix];
}

std::int32_t Landscape::highestGround(const Area& area) const
{
  std::int32_t highest = ground(area.x0, area.y0);
  for (std::int32_t x = area.x0; x <= area.x1; ++x)
    for (std::int32_t y = area.y0; y <= area.y1; ++y) highest = std::max(highest, ground(x, y));
  return highest;
}

void Landscape::raise(const Area& area, std::int32_t top)
{
  for (std::int32_t x = area.x0; x <= area.x1; ++x)
    for (std::int32_t y = area.y0; y <= area.y1; ++y)
      m_canvas.fillColumn(x, y, ground(x, y), top + 1, State::Occupied);
}

void Landscape::hide(const Area& area, std::int32_t depth, std::int32_t top)
{
  for (std::int32_t x = area.x0; x <= area.x1; ++x)
    for (std::int32_t y = area.y0; y <= area.y1; ++y)
      m_canvas.fillColumn(x, y, ground(x, y) - depth, top + 1, State::Unknown);
}

}  // namespace mrpt_mapconv::sim
