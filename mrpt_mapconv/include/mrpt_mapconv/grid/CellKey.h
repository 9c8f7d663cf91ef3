#pragma once

#include <cmath>
#include <cstdint>

namespace mrpt_mapconv::grid
{
/** The key k of the cell that holds a coordinate: k·resolution ≤ x < (k+1)·resolution, also where
 * x/resolution is rounded across a border.
 * \param x [m], less than 2^31 cells from 0 */
inline std::int32_t cellKey(double x, double resolution)
{
  auto key = static_cast<std::int32_t>(std::floor(x / resolution));
  while (key * resolution > x) --key;
  while ((key + 1) * resolution <= x) ++key;
  return key;
}

}  // namespace mrpt_mapconv::grid
