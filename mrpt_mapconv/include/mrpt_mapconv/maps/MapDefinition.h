#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/metric_map_types.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <functional>
#include <string>
#include <vector>

namespace mrpt_mapconv::maps
{
/** \exception std::invalid_argument unless it is within [0.0001, 1000] m: beyond that MRPT's floats
 * fail */
double checkedResolution(double resolution);

/** The ini sections of one map's definition, PREFIX_creationOpts and so on, which is what a
 * loadFromConfigFile_map_specific() reads. Errors name section, key and value, and what would be
 * right; unknown keys give warnings. */
class DefinitionSections
{
 public:
  DefinitionSections(const mrpt::config::CConfigFileBase& source, std::string prefix);

  /** The name of a section, which from now on is a known one. \param ending e.g. "_insertOpts" */
  std::string name(const std::string& ending);
  /** Reads PREFIX_creationOpts: the size of a cell [m] and the flags that all maps share. MRPT has
   * read the latter already, but takes "true ; why" for false.
   * \param readMore reads further keys; may be empty */
  void readCreation(double& resolution, mrpt::maps::TMapGenericParams& shared,
                    const std::function<void(params::StrictSection&)>& readMore = {});
  /** Reads PREFIX_likelihoodOpts, see loadGridLikelihoodOptions(). */
  void readLikelihood(mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions& options);
  /** Warns of sections that begin with the prefix and are not known: most likely a typo. */
  void warnUnknown() const;

 private:
  const mrpt::config::CConfigFileBase& m_source;
  std::string m_prefix;
  std::vector<std::string> m_known;
};

}  // namespace mrpt_mapconv::maps
