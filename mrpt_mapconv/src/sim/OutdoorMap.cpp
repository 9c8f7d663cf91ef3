#include <mrpt_mapconv/sim/SampleMaps.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "Landscape.h"
#include "Noise.h"

namespace mrpt_mapconv::sim
{
namespace
{
using State = VoxelCanvas::State;

/** Builds what stands on the ground, plot by plot. Lengths in metres are turned into voxels where
 * they are used. */
class Settlement
{
 public:
  Settlement(Landscape& land, std::uint64_t seed) : m_land(land), m_seed(seed) {}

  /** Every plot of about 20 × 20 m gets a house, a wall, a shed or some trees. */
  void settle()
  {
    const Area& all = m_land.area();
    const std::int32_t side = all.x1 - all.x0 + 1;
    const std::int32_t plots = std::max(1, side / m_land.cells(20));
    for (std::int32_t i = 0; i < plots; ++i)
      for (std::int32_t j = 0; j < plots; ++j)
        settlePlot({all.x0 + i * side / plots, all.y0 + j * side / plots,
                    all.x0 + (i + 1) * side / plots - 1, all.y0 + (j + 1) * side / plots - 1},
                   Dice(hashAt(m_seed, i, j)));
  }

  /** A deck on piers across the middle of the map, free under and above. */
  void bridge()
  {
    const Area& all = m_land.area();
    const std::int32_t reach = std::min(m_land.cells(15), (all.x1 - all.x0) / 4);
    const std::int32_t half = m_land.cells(1.5);
    const Area deck = {-reach, -half, reach, half};
    const std::int32_t top = m_land.highestGround(deck) + m_land.cells(3.5);
    roof(deck, top, m_land.cells(0.4), m_land.cells(2.5));
    for (std::int32_t x = deck.x0; x <= deck.x1; x += m_land.cells(10))
      m_land.raise({x, -half / 2, x + m_land.cells(0.4), half / 2}, top);
  }

  /** Places that no ray has reached. */
  void holes()
  {
    const Area& all = m_land.area();
    const ValueNoise patches(m_seed + 11, m_land.cells(7)), edges(m_seed + 12, m_land.cells(1.2));
    for (std::int32_t x = all.x0; x <= all.x1; ++x)
      for (std::int32_t y = all.y0; y <= all.y1; ++y)
        if (5 * patches(x, y) + edges(x, y) > 5 * ValueNoise::kOne)
          m_land.hide({x, y, x, y}, m_land.cells(1), m_land.canvas().box().max[2]);
  }

 private:
  void settlePlot(const Area& plot, Dice dice)
  {
    const std::int32_t kind = dice(0, 99);
    if (kind < 18)
      house(placeIn(plot, dice(m_land.cells(7), m_land.cells(13)),
                    dice(m_land.cells(7), m_land.cells(13)), dice),
            dice);
    else if (kind < 30)
      shed(placeIn(plot, m_land.cells(6), m_land.cells(8), dice), dice);
    else if (kind < 50)
      wall(plot, dice);
    else
      for (int left = dice(2, 7); left > 0; --left)
        tree(dice(plot.x0, plot.x1), dice(plot.y0, plot.y1), dice);
  }

  /** A rectangle of that size somewhere in the plot, with room for a path around. */
  Area placeIn(const Area& plot, std::int32_t width, std::int32_t depth, Dice& dice) const
  {
    const std::int32_t path = m_land.cells(2);
    const auto begin = [&](std::int32_t low, std::int32_t high, std::int32_t length)
    { return dice(low + path, std::max(low + path, high - path - length)); };
    const std::int32_t x = begin(plot.x0, plot.x1, width), y = begin(plot.y0, plot.y1, depth);
    return {x, y, std::min(x + width, plot.x1), std::min(y + depth, plot.y1)};
  }

  /** Walls seen from outside; inside and above all is unknown. */
  void house(const Area& a, Dice& dice)
  {
    const std::int32_t thick = m_land.cells(0.4), sky = m_land.canvas().box().max[2];
    const std::int32_t top = m_land.highestGround(a) + dice(m_land.cells(3), m_land.cells(8));
    m_land.raise(a, top);
    m_land.hide({a.x0 + thick, a.y0 + thick, a.x1 - thick, a.y1 - thick}, m_land.cells(1), sky);
    for (std::int32_t x = a.x0; x <= a.x1; ++x)
      for (std::int32_t y = a.y0; y <= a.y1; ++y)
        m_land.canvas().fillColumn(x, y, top + 1, sky + 1, State::Unknown);
  }

  /** A roof on posts, free under it. */
  void shed(const Area& a, Dice& dice)
  {
    const std::int32_t top = m_land.highestGround(a) + m_land.cells(2.8), post = m_land.cells(0.4);
    roof(a, top, m_land.cells(0.2), dice(1, m_land.cells(1.5)));
    for (const std::int32_t x : {a.x0, a.x1 - post + 1})
      for (const std::int32_t y : {a.y0, a.y1 - post + 1})
        m_land.raise({x, y, x + post - 1, y + post - 1}, top);
  }

  /** A slab that ends at the key `top`, free below, free for `above` voxels over it. */
  void roof(const Area& a, std::int32_t top, std::int32_t thick, std::int32_t above)
  {
    VoxelCanvas& canvas = m_land.canvas();
    for (std::int32_t x = a.x0; x <= a.x1; ++x)
      for (std::int32_t y = a.y0; y <= a.y1; ++y)
      {
        canvas.fillColumn(x, y, m_land.ground(x, y), top - thick + 1, State::Free);
        canvas.fillColumn(x, y, top - thick + 1, top + 1, State::Occupied);
        canvas.fillColumn(x, y, top + 1, top + 1 + above, State::Free);
        canvas.fillColumn(x, y, top + 1 + above, canvas.box().max[2] + 1, State::Unknown);
      }
  }

  /** A free-standing wall; what lies low behind it was not seen. */
  void wall(const Area& plot, Dice& dice)
  {
    const bool alongX = dice(0, 1) == 1;
    const std::int32_t length = dice(m_land.cells(8), m_land.cells(16)), thick = m_land.cells(0.4);
    const Area a = alongX ? placeIn(plot, length, thick, dice) : placeIn(plot, thick, length, dice);
    const std::int32_t height = dice(m_land.cells(0.6), m_land.cells(2.5));
    const std::int32_t shadow = dice(m_land.cells(1), m_land.cells(4));
    for (std::int32_t i = 1; i <= shadow; ++i)
    {
      const Area strip =
          alongX ? Area{a.x0, a.y1 + i, a.x1, a.y1 + i} : Area{a.x1 + i, a.y0, a.x1 + i, a.y1};
      const std::int32_t hidden = height * (shadow + 1 - i) / (shadow + 1);
      m_land.hide(strip, m_land.cells(1), m_land.highestGround(strip) + hidden);
    }
    for (std::int32_t x = a.x0; x <= a.x1; ++x)
      for (std::int32_t y = a.y0; y <= a.y1; ++y)
        m_land.raise({x, y, x, y}, m_land.ground(x, y) + height - 1);
  }

  /** A trunk and a crown: leaves and gaps on its outside, nothing seen within and above. */
  void tree(std::int32_t cx, std::int32_t cy, Dice& dice)
  {
    const std::int32_t radius = dice(m_land.cells(1.2), m_land.cells(3.0));
    const std::int32_t middle =
        m_land.ground(cx, cy) + dice(m_land.cells(1.8), m_land.cells(3.0)) + radius;
    const std::uint64_t leaves = hashAt(m_seed + 13, cx, cy);
    for (std::int32_t dx = -radius; dx <= radius; ++dx)
      for (std::int32_t dy = -radius; dy <= radius; ++dy)
        for (std::int32_t dz = -radius; dz <= m_land.canvas().box().max[2] - middle; ++dz)
          if (const std::int32_t flat = dx * dx + dy * dy; flat <= radius * radius)
            m_land.canvas().set(
                cx + dx, cy + dy, middle + dz,
                crown(flat, dz, radius, hashAt(leaves + std::uint64_t(dz + radius), dx, dy)));
    const std::int32_t trunk = m_land.cells(0.2);
    m_land.raise({cx - trunk, cy - trunk, cx + trunk, cy + trunk}, middle - radius / 2);
  }

  /** State of a voxel at squared horizontal distance `flat` and height `dz` from a crown's middle.
   */
  State crown(std::int32_t flat, std::int32_t dz, std::int32_t radius, std::uint64_t random) const
  {
    const std::int32_t outer = radius * radius, inner = (radius - 2) * (radius - 2);
    const std::int32_t distance = flat + dz * dz;
    if (distance > outer) return dz < 0 ? State::Free : State::Unknown;
    if (distance < inner && radius > 2) return State::Unknown;
    return random % 8 < 5 ? State::Occupied : State::Free;
  }

  Landscape& m_land;
  std::uint64_t m_seed;
};

void checkRange(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
    throw std::invalid_argument(std::string("outdoorMap: ") + name + " is " +
                                std::to_string(value) + " m, but must lie in [" +
                                std::to_string(low) + ", " + std::to_string(high) + "]");
}
}  // namespace

void OutdoorOptions::check() const
{
  checkRange("size", size, 10, 500);
  checkRange("resolution", resolution, 0.05, 1);
  constexpr double kMostCells = 2500;  // 2 GB of canvas
  if (size / resolution > kMostCells)
    throw std::invalid_argument("outdoorMap: resolution is " + std::to_string(resolution) +
                                " m, but must be at least " + std::to_string(size / kMostCells) +
                                " m for a size of " + std::to_string(size) + " m");
}

std::unique_ptr<octomap::OcTree> outdoorMap(const OutdoorOptions& options)
{
  options.check();
  Landscape land(options);
  Settlement settlement(land, options.seed);
  settlement.settle();
  settlement.bridge();
  settlement.holes();
  land.canvas().forgetUnseen();
  return land.canvas().toOctree(options.resolution);
}

}  // namespace mrpt_mapconv::sim
