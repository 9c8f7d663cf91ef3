#include "experiment/report/Spread.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mapconv
{
Spread spreadOf(std::vector<double> values)
{
  if (values.empty()) return {NAN, NAN, NAN, NAN, NAN, NAN};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share)
  {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (values[above] - values[below]) * (place - static_cast<double>(below));
  };
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {values.front(), at(0.25),      at(0.5),
          at(0.75),       values.back(), sum / static_cast<double>(values.size())};
}

}  // namespace mapconv
