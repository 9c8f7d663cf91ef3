#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/metric_map_types.h>
#include <mrpt_mapconv/grid/Resolution.h>
#include <mrpt_mapconv/params/Fields.h>

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
  /** Reads PREFIX_creationOpts: the fields of a struct with a list (params/Fields.h) that has a
   * resolution [m] among them, and the flags that all maps share.
   * \param checkMore calls StrictSection::fail() for what else is not valid; may be empty */
  template <class Creation>
  void readCreation(Creation& creation, mrpt::maps::TMapGenericParams& shared,
                    const std::function<void(const params::StrictSection&)>& checkMore = {})
  {
    params::StrictSection ini(m_source, name("_creationOpts"));
    params::readFields(ini, creation);
    if (!grid::isResolution(creation.resolution)) ini.fail("resolution", grid::kRightResolution);
    if (checkMore) checkMore(ini);
    readShared(ini, shared);
    ini.warnUnknown();
  }
  /** Reads a section with the fields of a struct with a list, all of whose values are valid. */
  template <class Options>
  void read(const std::string& ending, Options& options)
  {
    params::StrictSection ini(m_source, name(ending));
    params::readFields(ini, options);
    ini.warnUnknown();
  }
  /** Reads PREFIX_likelihoodOpts, see loadGridLikelihoodOptions(). */
  void readLikelihood(mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions& options);
  /** Warns of sections that begin with the prefix and are not known: most likely a typo. */
  void warnUnknown() const;

 private:
  /** MRPT has read these flags already, but takes "true ; why" for false. */
  static void readShared(params::StrictSection& ini, mrpt::maps::TMapGenericParams& shared);

  const mrpt::config::CConfigFileBase& m_source;
  std::string m_prefix;
  std::vector<std::string> m_known;
};

}  // namespace mrpt_mapconv::maps
