#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/GridLikelihoodOptions.h>

#include "MapSections.h"

IMPLEMENTS_SERIALIZABLE(CFreeSpaceGridMap2D, COccupancyGridMap2D, mrpt_mapconv)

//  ===== MRPT's map factory: a static of this file registers the class as the library is loaded
//  =====
MAP_DEFINITION_REGISTER("mrpt_mapconv::CFreeSpaceGridMap2D,freeSpaceGrid",
                        mrpt_mapconv::CFreeSpaceGridMap2D)

namespace mrpt_mapconv
{
namespace
{
const std::vector<std::string> kSections{"_creationOpts", "_insertOpts", "_conversionOpts",
                                         "_likelihoodOpts", "_renderOpts"};
}  // namespace

CFreeSpaceGridMap2D::TMapDefinition::TMapDefinition() = default;

void CFreeSpaceGridMap2D::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& sectionNamePrefix)
{
  params::StrictSection creation(source, sectionNamePrefix + kSections[0]);
  params::readFields(creation, creationOpts);
  if (!grid::isResolution(creationOpts.resolution))
    creation.fail("resolution", grid::kRightResolution);
  maps::readSharedParams(creation, genericMapParams);
  creation.warnUnknown();
  insertionOpts.loadFromConfigFile(source, sectionNamePrefix + kSections[1]);
  conversionOpts.loadFromConfigFile(source, sectionNamePrefix + kSections[2]);
  maps::loadGridLikelihoodOptions(source, sectionNamePrefix + kSections[3], likelihoodOpts);
  params::StrictSection rendering(source, sectionNamePrefix + kSections[4]);
  params::readFields(rendering, renderOpts);
  rendering.warnUnknown();
  maps::warnUnknownSections(source, sectionNamePrefix, kSections);
}

void CFreeSpaceGridMap2D::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
  params::printFields(creationOpts, out);
  insertionOpts.dumpToTextStream(out);
  conversionOpts.dumpToTextStream(out);
  likelihoodOpts.dumpToTextStream(out);
  params::printFields(renderOpts, out);
}

mrpt::maps::CMetricMap* CFreeSpaceGridMap2D::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
  const auto& def = dynamic_cast<const TMapDefinition&>(definition);
  auto map = std::make_unique<CFreeSpaceGridMap2D>(def.creationOpts.resolution);
  map->voxelInsertionOptions = def.insertionOpts;
  map->setConversionOptions(def.conversionOpts);
  map->likelihoodOptions = def.likelihoodOpts;
  map->renderingOptions = def.renderOpts;
  return map.release();
}

}  // namespace mrpt_mapconv
