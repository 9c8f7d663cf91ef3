#pragma once

#include <mrpt_mapconv/path/LiftPath.h>

#include <optional>
#include <vector>

#include "SphereFit.h"

namespace mrpt_mapconv::path
{
/** A bound is violated only by more than this [m]: layers hold heights as floats, so that a gap of
 * exactly the sphere's diameter can seem a little lower. */
constexpr double kHeightSlack = 1e-5;

/** Heights bottom < z < top at which a sphere's centre may not be [m]. */
struct ForbiddenHeights
{
  double bottom, top;
  bool contains(double z) const { return z > bottom + kHeightSlack && z < top - kHeightSlack; }
};

/** Adds a range to others that do not overlap, and joins it with those that it overlaps. */
void join(ForbiddenHeights range, std::vector<ForbiddenHeights>& ranges);

/** The same, at once for the many ranges that another one covers. */
inline void forbid(const ForbiddenHeights& range, std::vector<ForbiddenHeights>& ranges)
{
  for (const ForbiddenHeights& other : ranges)
    if (range.bottom >= other.bottom && range.top <= other.top) return;
  join(range, ranges);
}

/** A height and what decided it. */
struct RuledHeight
{
  double z;  //!< [m]
  HeightRule rule;
};

/** The height in [limits.low, limits.high] and outside of all forbidden ones that is nearest to
 * `wanted`; of two as near, the higher. Nothing if there is none. */
std::optional<RuledHeight> nearestHeight(double wanted, const SphereLimits& limits,
                                         const std::vector<ForbiddenHeights>& forbidden);

}  // namespace mrpt_mapconv::path
