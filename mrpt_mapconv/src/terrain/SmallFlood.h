#pragma once

#include <array>

#include "SeedPlane.h"

namespace mrpt_mapconv::terrain
{
/** Finds out quickly, and changing nothing, whether a flood would stay too small for a plane. */
class SmallFlood
{
 public:
  explicit SmallFlood(const PlaneSearch& search) : m_search(search) {}

  /** False if a flood from the seed over cells without a plane has less than minCells. */
  bool mayBePlane(const CellRef& seed, const Plane& plane);

 private:
  static constexpr std::int32_t kSide = 64, kMiddle = kSide / 2;

  bool visit(std::int32_t dx, std::int32_t dy);

  PlaneSearch m_search;
  std::array<std::uint64_t, kSide> m_visited;
};

}  // namespace mrpt_mapconv::terrain
