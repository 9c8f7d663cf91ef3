#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/core/initializer.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/GridLikelihoodOptions.h>
#include <mrpt_mapconv/maps/StrictSection.h>

#include <algorithm>
#include <array>

IMPLEMENTS_SERIALIZABLE(CFreeSpaceGridMap2D, COccupancyGridMap2D, mrpt_mapconv)

//  ===== MRPT's map factory: a static of this file registers the class as the library is loaded
//  =====
MAP_DEFINITION_REGISTER("mrpt_mapconv::CFreeSpaceGridMap2D,freeSpaceGrid",
                        mrpt_mapconv::CFreeSpaceGridMap2D)

MRPT_INITIALIZER(registerMrptMapconvClasses)
{
  mrpt::rtti::registerClass(CLASS_ID(mrpt_mapconv::CFreeSpaceGridMap2D));
}

namespace mrpt_mapconv
{
namespace
{
const std::array<std::string, 4> kSections{"_creationOpts", "_insertOpts", "_conversionOpts",
                                           "_likelihoodOpts"};

/** A section with our prefix and a name that is none of ours is most likely a typo. */
void warnUnknownSections(const mrpt::config::CConfigFileBase& source, const std::string& prefix)
{
  std::vector<std::string> sections;
  source.getAllSections(sections);
  for (const auto& section : sections)
  {
    if (section.rfind(prefix + "_", 0) != 0) continue;
    const auto suffix = section.substr(prefix.size());
    if (std::find(kSections.begin(), kSections.end(), suffix) != kSections.end()) continue;
    mrpt::system::COutputLogger log("mrpt_mapconv");
    log.logStr(mrpt::system::LVL_WARN, "unknown section '" + section + "' has no effect");
  }
}

/** MRPT has read the flags that all maps share already, but takes "true ; why" for false. */
void readCreationOptions(const mrpt::config::CConfigFileBase& source, const std::string& section,
                         CFreeSpaceGridMap2D::TMapDefinition& definition)
{
  maps::StrictSection ini(source, section);
  ini.read("resolution", definition.resolution);
  if (definition.resolution < 1e-4 || definition.resolution > 1e3)
    ini.fail("resolution", "within [0.0001, 1000] m");
  auto& shared = definition.genericMapParams;
  ini.read("enableSaveAs3DObject", shared.enableSaveAs3DObject);
  ini.read("enableObservationLikelihood", shared.enableObservationLikelihood);
  ini.read("enableObservationInsertion", shared.enableObservationInsertion);
  ini.warnUnknown();
}
}  // namespace

CFreeSpaceGridMap2D::TMapDefinition::TMapDefinition() = default;

void CFreeSpaceGridMap2D::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& sectionNamePrefix)
{
  readCreationOptions(source, sectionNamePrefix + kSections[0], *this);
  insertionOpts.loadFromConfigFile(source, sectionNamePrefix + kSections[1]);
  conversionOpts.loadFromConfigFile(source, sectionNamePrefix + kSections[2]);
  maps::loadGridLikelihoodOptions(source, sectionNamePrefix + kSections[3], likelihoodOpts);
  warnUnknownSections(source, sectionNamePrefix);
}

void CFreeSpaceGridMap2D::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
  LOADABLEOPTS_DUMP_VAR(resolution, double);
  insertionOpts.dumpToTextStream(out);
  conversionOpts.dumpToTextStream(out);
  likelihoodOpts.dumpToTextStream(out);
}

mrpt::maps::CMetricMap* CFreeSpaceGridMap2D::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
  const auto& def = dynamic_cast<const TMapDefinition&>(definition);
  auto map = std::make_unique<CFreeSpaceGridMap2D>(def.resolution);
  map->voxelInsertionOptions = def.insertionOpts;
  map->setConversionOptions(def.conversionOpts);
  map->likelihoodOptions = def.likelihoodOpts;
  return map.release();
}

}  // namespace mrpt_mapconv
