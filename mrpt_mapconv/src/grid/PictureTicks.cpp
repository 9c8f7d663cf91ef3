#include "PictureTicks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mrpt_mapconv::grid::picture
{
namespace
{
constexpr double kSlack = 1e-9;  // a value that is round but for its last bits counts as round
}

double roundStep(double least)
{
  const double power = std::pow(10.0, std::floor(std::log10(least) + kSlack));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1 - kSlack)) return factor * power;
  return 10 * power;
}

int decimalsOf(double step)
{
  return std::clamp(static_cast<int>(-std::floor(std::log10(step) + kSlack)), 0, 6);
}

std::string number(double value, int decimals)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, value);
  const std::string out = text;
  const bool isZero = out.find_first_not_of("-0.") == std::string::npos;
  return isZero && out.front() == '-' ? out.substr(1) : out;
}

std::vector<Tick> ticks(double min, double max, double leastStep)
{
  const double step = roundStep(leastStep);
  const int decimals = decimalsOf(step);
  std::vector<Tick> out;
  for (double i = std::ceil(min / step - kSlack); i * step <= max + kSlack * step; ++i)
    out.push_back({i * step, number(i * step, decimals)});
  return out;
}

}  // namespace mrpt_mapconv::grid::picture
