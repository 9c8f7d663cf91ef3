#include "MapSections.h"

#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>

namespace mrpt_mapconv::maps
{
namespace
{
constexpr double kFinest = 1e-4, kCoarsest = 1e3;  // [m]; beyond that MRPT's floats fail
constexpr const char* kRightResolution = "within [0.0001, 1000] m";

bool isResolution(double resolution) { return resolution >= kFinest && resolution <= kCoarsest; }
}  // namespace

double checkedResolution(double resolution)
{
  params::require(isResolution(resolution), "resolution", resolution, kRightResolution);
  return resolution;
}

void readCreationOptions(params::StrictSection& ini, double& resolution,
                         mrpt::maps::TMapGenericParams& shared)
{
  ini.read("resolution", resolution);
  if (!isResolution(resolution)) ini.fail("resolution", kRightResolution);
  ini.read("enableSaveAs3DObject", shared.enableSaveAs3DObject);
  ini.read("enableObservationLikelihood", shared.enableObservationLikelihood);
  ini.read("enableObservationInsertion", shared.enableObservationInsertion);
}

void warnUnknownSections(const mrpt::config::CConfigFileBase& source, const std::string& prefix,
                         const std::vector<std::string>& endings)
{
  std::vector<std::string> sections;
  source.getAllSections(sections);
  for (const auto& section : sections)
  {
    if (section.rfind(prefix + "_", 0) != 0) continue;
    const auto ending = section.substr(prefix.size());
    if (std::find(endings.begin(), endings.end(), ending) != endings.end()) continue;
    mrpt::system::COutputLogger log("mrpt_mapconv");
    log.logStr(mrpt::system::LVL_WARN, "unknown section '" + section + "' has no effect");
  }
}

}  // namespace mrpt_mapconv::maps
