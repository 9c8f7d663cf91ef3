#pragma once

namespace mrpt_mapconv::path
{
/** Heights, upwards [m]. */
struct HeightRange
{
  double low, high;

  bool empty() const { return low > high; }
  HeightRange operator+(double z) const { return {low + z, high + z}; }
};

}  // namespace mrpt_mapconv::path
