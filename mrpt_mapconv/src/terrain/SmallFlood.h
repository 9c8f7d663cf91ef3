#pragma once

#include <algorithm>
#include <array>

#include "SeedPlane.h"

namespace mrpt_mapconv::terrain
{
/** Finds out quickly, and changing nothing, whether a flood would stay too small for a plane. */
class SmallFlood
{
 public:
  explicit SmallFlood(const PlaneSearch& search)
      : m_search(search), m_most(std::min(search.minCells, kMiddle - 1))
  {
  }

  /** False if fewer than minCells cells without a plane that are near this one are connected with
   * the seed. */
  bool mayBePlane(const CellRef& seed, const Plane& plane);

 private:
  static constexpr std::int32_t kSide = 64, kMiddle = kSide / 2;

  struct Offset
  {
    std::int32_t x, y;
  };

  void start();
  bool visit(const Offset& at);
  template <class Open>
  bool isLarge(const CellRef& seed, const Open& open);

  PlaneSearch m_search;
  std::int32_t m_most;  //!< cells that are enough; so many stay within the square
  std::array<std::uint64_t, kSide> m_visited;
};

template <class Open>
bool SmallFlood::isLarge(const CellRef& seed, const Open& open)
{
  constexpr std::array<Offset, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  std::array<Offset, kMiddle> cells;
  start();
  visit(cells[0] = {0, 0});
  std::int32_t count = 1;
  for (std::int32_t i = 0; i < count; ++i)
  {
    const Offset from = cells[static_cast<std::size_t>(i)];
    for (const Offset& step : kSteps)
    {
      const Offset to{from.x + step.x, from.y + step.y};
      if (!visit(to)) continue;
      const CellRef cell = cellAt(*seed.tile, seed.ix + to.x, seed.iy + to.y);
      if (!cell || !cell.tile->isKnown(cell.ix, cell.iy) ||
          cell.tile->plane[cell.index()] != kNoPlane || !open(cell))
        continue;
      cells[static_cast<std::size_t>(count++)] = to;
      if (count == m_most) return true;
    }
  }
  return false;
}

}  // namespace mrpt_mapconv::terrain
