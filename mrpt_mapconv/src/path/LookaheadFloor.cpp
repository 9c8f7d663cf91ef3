#include "LookaheadFloor.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace mrpt_mapconv::path
{
std::vector<float> highestFloors(const std::vector<double>& arc, const std::vector<float>& floors,
                                 double reach)
{
  std::vector<float> highest(arc.size(), std::numeric_limits<float>::quiet_NaN());
  // Points in the window that may still become the highest: further on and lower, one after
  // another.
  std::vector<std::size_t> candidates;
  std::size_t first = 0, next = 0;
  for (std::size_t i = 0; i < arc.size(); ++i)
  {
    for (; next < arc.size() && arc[next] <= arc[i] + reach; ++next)
    {
      if (std::isnan(floors[next])) continue;
      while (candidates.size() > first && floors[candidates.back()] <= floors[next])
        candidates.pop_back();
      candidates.push_back(next);
    }
    while (first < candidates.size() && arc[candidates[first]] < arc[i] - reach) ++first;
    if (first < candidates.size()) highest[i] = floors[candidates[first]];
  }
  return highest;
}

}  // namespace mrpt_mapconv::path
