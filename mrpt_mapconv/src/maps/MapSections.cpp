#include "MapSections.h"

#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/grid/Resolution.h>

#include <algorithm>

namespace mrpt_mapconv::maps
{
double checkedResolution(double resolution)
{
  grid::requireResolution(resolution);
  return resolution;
}

void readSharedParams(params::StrictSection& ini, mrpt::maps::TMapGenericParams& shared)
{
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
