#pragma once

#include <algorithm>

namespace mrpt_mapconv::oracle
{
/** Shares of a straight piece between which a coordinate lies in [low, high), cut by one axis after
 * the other; end < begin if no part of it does. */
struct Shares
{
  double begin = 0, end = 1;

  void cut(double from, double to, double low, double high)
  {
    if (from == to)
    {
      if (from < low || from >= high) end = -1;
      return;
    }
    const auto [first, second] =
        std::minmax({(low - from) / (to - from), (high - from) / (to - from)});
    begin = std::max(begin, first);
    end = std::min(end, second);
  }
};

}  // namespace mrpt_mapconv::oracle
