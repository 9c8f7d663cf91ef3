#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/scan/ProfileParams.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace mrpt_mapconv::scan
{
using params::require;

namespace
{
constexpr std::int32_t kMostSectors = 1000000;
constexpr double kPi = 3.14159265358979323846;

void checkUpperEnd(const char* lowName, double low, const char* highName, double high)
{
  if (std::isfinite(high) && high > low) return;
  std::ostringstream right;
  right << "a finite height above " << lowName << " = " << low << " m";
  require(false, highName, high, right.str());
}

void checkStructure(const ProfileParams& params)
{
  if (std::isnan(params.structureMinZ) || std::isnan(params.structureMaxZ))
    throw std::invalid_argument(
        std::string(std::isnan(params.structureMinZ) ? "structureMinZ" : "structureMaxZ") +
        " is missing: the reflection filter needs structureMinZ and structureMaxZ, a range of "
        "heights just under the ceiling [m] (or reflectionFilter = false)");
  require(std::isfinite(params.structureMinZ), "structureMinZ", params.structureMinZ,
          "a finite height [m]");
  checkUpperEnd("structureMinZ", params.structureMinZ, "structureMaxZ", params.structureMaxZ);
}
}  // namespace

const std::vector<std::string>& namesOf(Model)
{
  static const std::vector<std::string> names{"wholeShape", "closestPoint"};
  return names;
}

void ProfileParams::check() const
{
  require(std::isfinite(objectMinZ), "objectMinZ", objectMinZ, "a finite height [m]");
  checkUpperEnd("objectMinZ", objectMinZ, "objectMaxZ", objectMaxZ);
  require(std::isfinite(maxRange) && maxRange > 0, "maxRange", maxRange, "a range > 0 m");
  require(minRange >= 0 && minRange < maxRange, "minRange", minRange,
          "at least 0 m and below maxRange");
  require(sectors >= 0 && sectors <= kMostSectors, "sectors", sectors,
          "a whole number from 1 to 1000000, or 0 for the default");
  require((structureGap >= 0 && structureGap <= kPi) || structureGap == -1, "structureGap",
          structureGap, "an angle of at most half a turn, or -1 for the default");
  require(
      (structureTolerance >= 0 && std::isfinite(structureTolerance)) || structureTolerance == -1,
      "structureTolerance", structureTolerance, "a length of at least 0 m, or -1 for one cell");
  if (reflectionFilter) checkStructure(*this);
}

}  // namespace mrpt_mapconv::scan
