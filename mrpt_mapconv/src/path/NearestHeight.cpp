#include "NearestHeight.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::path
{
namespace
{
/** Goes from z to the end of what forbids it, until nothing does. */
double pastForbidden(double z, const std::vector<ForbiddenHeights>& forbidden,
                     double ForbiddenHeights::*end)
{
  for (bool moved = true; moved;)
  {
    moved = false;
    for (const ForbiddenHeights& range : forbidden)
      if (range.contains(z))
      {
        z = range.*end;
        moved = true;
      }
  }
  return z;
}
}  // namespace

void join(ForbiddenHeights range, std::vector<ForbiddenHeights>& ranges)
{
  for (std::size_t i = 0; i < ranges.size();)
  {
    const ForbiddenHeights other = ranges[i];
    if (other.top <= range.bottom + kHeightSlack || range.top <= other.bottom + kHeightSlack)
    {
      ++i;
      continue;
    }
    range = {std::min(range.bottom, other.bottom), std::max(range.top, other.top)};
    ranges[i] = ranges.back();
    ranges.pop_back();
    i = 0;  // it is larger now and may overlap one that it did not before
  }
  ranges.push_back(range);
}

std::optional<RuledHeight> nearestHeight(double wanted, const SphereLimits& limits,
                                         const std::vector<ForbiddenHeights>& forbidden)
{
  const double up = pastForbidden(wanted < limits.low - kHeightSlack ? limits.low : wanted,
                                  forbidden, &ForbiddenHeights::top);
  const double down = pastForbidden(wanted > limits.high + kHeightSlack ? limits.high : wanted,
                                    forbidden, &ForbiddenHeights::bottom);
  const bool upFits = up <= limits.high + kHeightSlack,
             downFits = down >= limits.low - kHeightSlack;
  if (upFits && up == wanted) return RuledHeight{wanted, HeightRule::FloorAhead};
  if (upFits && (!downFits || up - wanted <= wanted - down + kHeightSlack))
    return RuledHeight{up, std::abs(up - limits.low) <= kHeightSlack ? HeightRule::SphereFloor
                                                                     : HeightRule::SphereSlab};
  if (downFits)
    return RuledHeight{down, std::abs(down - limits.high) <= kHeightSlack
                                 ? HeightRule::SphereCeiling
                                 : HeightRule::SphereSlab};
  return std::nullopt;
}

}  // namespace mrpt_mapconv::path
