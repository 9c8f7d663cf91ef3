#include "input/SeemsGeographic.h"

#include <mrpt_mapconv/cloud/CloudFields.h>

#include <cmath>

namespace mapconv
{
using namespace mrpt_mapconv;
using cloud::Field;
using cloud::PointCloud;

namespace
{
bool isWithin(const cloud::Range& range, double most)
{
  return range.min >= -most && range.max <= most;
}

/** Whether most steps from a point to the next one rise or fall a thousand times as much as they go
 * along: metres over degrees do, since a degree has 1e5 of them; a mast does not. */
bool risesThousandfold(const PointCloud& cloud)
{
  constexpr double kThousandfold = 1000;
  constexpr double kSame = 1e-8;  // below the last digit of degrees: straight up, or rounding
  std::size_t steps = 0, steep = 0;
  for (std::size_t i = 1; i < cloud.size(); ++i)
  {
    const double along = std::hypot(cloud.x[i] - cloud.x[i - 1], cloud.y[i] - cloud.y[i - 1]);
    if (along < kSame) continue;
    ++steps;
    if (std::abs(cloud.z[i] - cloud.z[i - 1]) > kThousandfold * along) ++steep;
  }
  return 2 * steep > steps;
}
}  // namespace

bool seemsGeographic(const PointCloud& cloud)
{
  constexpr double kWidest = 0.2, kLeastHeight = 1;
  const auto x = rangeOf(cloud, Field::X), y = rangeOf(cloud, Field::Y),
             z = rangeOf(cloud, Field::Z);
  if (!x || !y || !z || !isWithin(*x, 180) || !isWithin(*y, 90)) return false;
  return x->max - x->min < kWidest && y->max - y->min < kWidest && z->max - z->min > kLeastHeight &&
         risesThousandfold(cloud);
}

}  // namespace mapconv
