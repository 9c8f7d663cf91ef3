#pragma once

#include <vector>

namespace mapconv
{
/** How measured values are spread; NaN without values. */
struct Spread
{
  double least = 0, lowerQuartile = 0, median = 0, upperQuartile = 0, most = 0, mean = 0;
};

/** Quartiles are interpolated linearly between the values next to them. */
Spread spreadOf(std::vector<double> values);

}  // namespace mapconv
