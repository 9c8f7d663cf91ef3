#include "input/NearOrigin.h"

#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** At 100 km a float has 8 mm; cells are counted in 31 bits. [m] */
constexpr std::array<double, 3> kFarthest = {1e8, 1e8, 1e5};

std::string placeOrSize(double place)
{
  constexpr double kMostDigits = 1e12;
  return std::abs(place) < kMostDigits ? params::placeText(place) : params::roundedText(place);
}

double distanceFrom(double origin, const cloud::Range& range)
{
  return std::max(std::abs(range.min - origin), std::abs(range.max - origin));
}
}  // namespace

void requireNearOrigin(const std::string& name, const Extent& extent,
                       const mrpt::math::TPoint3D& origin, const std::array<double, 3>& units)
{
  std::string fitting, far;
  bool canFit = true;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& range = extent.at(i);
    const double farthest = kFarthest.at(i) / units.at(i);
    double place = origin[i];
    if (distanceFrom(place, range) > farthest)
    {
      far = std::string(1, "xyz"[i]) + " of " + placeOrSize(range.min) + " to " +
            placeOrSize(range.max) + " is more than " + params::roundedText(farthest) +
            " from the origin's " + placeOrSize(place);
      place = std::floor(range.min);
      canFit &= distanceFrom(place, range) <= farthest;
    }
    fitting += (i == 0 ? "" : ",") + placeOrSize(place);
  }
  if (far.empty()) return;
  throw std::runtime_error(name + ": its " + far + ", where a map loses its precision; " +
                           (canFit ? "--origin " + fitting + " would do"
                                   : "no --origin would do: leave out what lies so far away"));
}

}  // namespace mapconv
