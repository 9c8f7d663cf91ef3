#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/maps/GridLikelihoodOptions.h>
#include <mrpt_mapconv/maps/MapDefinition.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <utility>

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

void DefinitionSections::readCreation(double& resolution, mrpt::maps::TMapGenericParams& shared,
                                      const std::function<void(params::StrictSection&)>& readMore)
{
  params::StrictSection ini(m_source, name("_creationOpts"));
  ini.read("resolution", resolution);
  if (!isResolution(resolution)) ini.fail("resolution", kRightResolution);
  ini.read("enableSaveAs3DObject", shared.enableSaveAs3DObject);
  ini.read("enableObservationLikelihood", shared.enableObservationLikelihood);
  ini.read("enableObservationInsertion", shared.enableObservationInsertion);
  if (readMore) readMore(ini);
  ini.warnUnknown();
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
