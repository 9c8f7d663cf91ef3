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

}  // namespace mrpt_mapconv::scan
