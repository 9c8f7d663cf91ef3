#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mrpt_mapconv::grid
{
/** How an occupancy layer writes its cells: 0 is free, -1 is unknown, (0, 1] is occupied. */
constexpr float kFree = 0.0f;
constexpr float kUnknown = -1.0f;

inline bool isFree(float occupancy) { return occupancy == kFree; }
inline bool isOccupied(float occupancy) { return occupancy > kFree; }

/** The raw 8-bit cell of MRPT's COccupancyGridMap2D (log-odds of *free* space) for an occupancy
 * value: +127 free, 0 unknown, −max(1, round(127·value)) occupied, so that every occupied cell
 * reads as occupied (p(free) < 0.5). */
inline std::int8_t rawGridCell(float occupancy)
{
  if (isFree(occupancy)) return 127;
  if (!isOccupied(occupancy)) return 0;
  const long scaled = std::lround(127.0 * std::min(1.0, static_cast<double>(occupancy)));
  return static_cast<std::int8_t>(-std::max(1L, scaled));
}

}  // namespace mrpt_mapconv::grid
