#include <mrpt/core/format.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/scan/ProfileSummary.h>

#include <cmath>

namespace mrpt_mapconv::scan
{
namespace
{
std::string range(double low, double high)
{
  return params::shortestText(low) + " to " + params::shortestText(high) + " m";
}

std::string wallText(const ProfileParams& params)
{
  if (!params.reflectionFilter) return "no reflection filter";
  if (std::isnan(params.structureMinZ) || std::isnan(params.structureMaxZ))
    return "no structure slice given";
  return "walls from " + range(params.structureMinZ, params.structureMaxZ);
}
}  // namespace

std::string summaryOf(const ProfileParams& params)
{
  return params::textOf(params.model) + ", objects from " +
         range(params.objectMinZ, params.objectMaxZ) + ", " + wallText(params);
}

std::string ceilingText(double height, const ProfileParams& params)
{
  // A slice as high as usual, so far below the ceiling that a tilted robot's scans stay below it.
  constexpr double kBelow = 0.1, kHigh = 0.25;
  const double high = std::floor((height - kBelow) * 20 + 1e-6) / 20, low = high - kHigh;
  return mrpt::format(
      "the ceiling, %.2f m above the robot's base, lies in the structure slice (%s) and would pass "
      "for walls on all sides: let the slice end below it, e.g. structureMinZ = %g and "
      "structureMaxZ = %g",
      height, range(params.structureMinZ, params.structureMaxZ).c_str(), low, high);
}

std::string overlapText(const ProfileParams& params)
{
  return "the structure slice (" + range(params.structureMinZ, params.structureMaxZ) +
         ") and the object slice (" + range(params.objectMinZ, params.objectMaxZ) +
         ") overlap: objects in both pass for walls, and what is behind them is cut; let "
         "structureMinZ be at least objectMaxZ";
}

}  // namespace mrpt_mapconv::scan
