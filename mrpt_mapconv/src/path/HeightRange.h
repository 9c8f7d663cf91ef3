#pragma once

#include <mrpt_mapconv/path/StepLimit.h>

namespace mrpt_mapconv::path
{
/** Heights, upwards [m]. */
struct HeightRange
{
  double low, high;

  bool empty() const { return low > high; }
  HeightRange operator+(double z) const { return {low + z, high + z}; }
};

/** What of a ground robot must be clear, over what it stands on; empty if it is no higher than what
 * it climbs. */
inline HeightRange groundBody(const StepLimit& limit, double minClearance)
{
  return {limit.least(), minClearance};
}

}  // namespace mrpt_mapconv::path
