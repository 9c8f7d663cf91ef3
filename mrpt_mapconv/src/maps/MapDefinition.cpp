#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/grid/Resolution.h>
#include <mrpt_mapconv/maps/GridLikelihoodOptions.h>
#include <mrpt_mapconv/maps/MapDefinition.h>

#include <algorithm>
#include <utility>

namespace mrpt_mapconv::maps
{
double checkedResolution(double resolution)
{
  grid::requireResolution(resolution);
  return resolution;
}

DefinitionSections::DefinitionSections(const mrpt::config::CConfigFileBase& source,
                                       std::string prefix)
    : m_source(source), m_prefix(std::move(prefix))
{
}

std::string DefinitionSections::name(const std::string& ending)
{
  m_known.push_back(m_prefix + ending);
  return m_known.back();
}

void DefinitionSections::readShared(params::StrictSection& ini,
                                    mrpt::maps::TMapGenericParams& shared)
{
  ini.read("enableSaveAs3DObject", shared.enableSaveAs3DObject);
  ini.read("enableObservationLikelihood", shared.enableObservationLikelihood);
  ini.read("enableObservationInsertion", shared.enableObservationInsertion);
}

void DefinitionSections::readLikelihood(
    mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions& options)
{
  loadGridLikelihoodOptions(m_source, name("_likelihoodOpts"), options);
}

void DefinitionSections::warnUnknown() const
{
  std::vector<std::string> sections;
  m_source.getAllSections(sections);
  for (const auto& section : sections)
  {
    if (section.rfind(m_prefix + "_", 0) != 0) continue;
    if (std::find(m_known.begin(), m_known.end(), section) != m_known.end()) continue;
    mrpt::system::COutputLogger log("mrpt_mapconv");
    log.logStr(mrpt::system::LVL_WARN, "unknown section '" + section + "' has no effect");
  }
}

}  // namespace mrpt_mapconv::maps
