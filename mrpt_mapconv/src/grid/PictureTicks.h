#pragma once

#include <string>
#include <vector>

namespace mrpt_mapconv::grid::picture
{
/** The least of 1, 2 or 5 times a power of ten that is not below `least` (> 0). */
double roundStep(double least);
/** Digits after the point that multiples of `step` need, 0 … 6. */
int decimalsOf(double step);
/** A fixed-point number, never "-0". */
std::string number(double value, int decimals);

struct Tick
{
  double value;
  std::string label;
};
/** Round values in [min, max], at least `leastStep` apart. */
std::vector<Tick> ticks(double min, double max, double leastStep);

}  // namespace mrpt_mapconv::grid::picture
