#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/MapDefinition.h>

IMPLEMENTS_SERIALIZABLE(CFreeSpaceGridMap2D, COccupancyGridMap2D, mrpt_mapconv)

//  ===== MRPT's map factory: a static of this file registers the class as the library is loaded
//  =====
MAP_DEFINITION_REGISTER("mrpt_mapconv::CFreeSpaceGridMap2D,freeSpaceGrid",
                        mrpt_mapconv::CFreeSpaceGridMap2D)

namespace mrpt_mapconv
{
CFreeSpaceGridMap2D::TMapDefinition::TMapDefinition() = default;

void CFreeSpaceGridMap2D::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& sectionNamePrefix)
{
  maps::DefinitionSections ini(source, sectionNamePrefix);
  ini.readCreation(creationOpts, genericMapParams);
  voxelInsertionOpts.loadFromConfigFile(source, ini.name("_insertOpts"));
  conversionOpts.loadFromConfigFile(source, ini.name("_conversionOpts"));
  ini.readLikelihood(likelihoodOpts);
  ini.read("_renderOpts", renderOpts);
  ini.warnUnknown();
}

void CFreeSpaceGridMap2D::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
  params::printFields(creationOpts, out);
  voxelInsertionOpts.dumpToTextStream(out);
  conversionOpts.dumpToTextStream(out);
  likelihoodOpts.dumpToTextStream(out);
  params::printFields(renderOpts, out);
}

mrpt::maps::CMetricMap* CFreeSpaceGridMap2D::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
  const auto& def = dynamic_cast<const TMapDefinition&>(definition);
  auto map = std::make_unique<CFreeSpaceGridMap2D>(def.creationOpts.resolution);
  map->warnings().rememberWith(def.said);
  map->voxelInsertionOptions = def.voxelInsertionOpts;
  map->setConversionOptions(def.conversionOpts);
  map->likelihoodOptions = def.likelihoodOpts;
  map->renderingOptions = def.renderOpts;
  return map.release();
}

}  // namespace mrpt_mapconv
