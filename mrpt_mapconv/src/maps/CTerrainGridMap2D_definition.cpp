#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/maps/CTerrainGridMap2D.h>
#include <mrpt_mapconv/maps/MapDefinition.h>

IMPLEMENTS_SERIALIZABLE(CTerrainGridMap2D, COccupancyGridMap2D, mrpt_mapconv)

//  ===== MRPT's map factory: a static of this file registers the class as the library is loaded
//  =====
MAP_DEFINITION_REGISTER("mrpt_mapconv::CTerrainGridMap2D,terrainGrid",
                        mrpt_mapconv::CTerrainGridMap2D)

namespace mrpt_mapconv
{
CTerrainGridMap2D::TMapDefinition::TMapDefinition() = default;

void CTerrainGridMap2D::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& sectionNamePrefix)
{
  maps::DefinitionSections ini(source, sectionNamePrefix);
  ini.readCreation(creationOpts, genericMapParams,
                   [this](const params::StrictSection& section)
                   {
                     if (!(creationOpts.maxGridCells >= 1)) section.fail("maxGridCells", ">= 1");
                   });
  terrainInsertionOpts.loadFromConfigFile(source, ini.name("_insertOpts"));
  terrainOpts.loadFromConfigFile(source, ini.name("_terrainOpts"));
  ini.readLikelihood(likelihoodOpts);
  ini.read("_renderOpts", renderOpts);
  ini.warnUnknown();
}

void CTerrainGridMap2D::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
  params::printFields(creationOpts, out);
  terrainInsertionOpts.dumpToTextStream(out);
  terrainOpts.dumpToTextStream(out);
  likelihoodOpts.dumpToTextStream(out);
  params::printFields(renderOpts, out);
}

mrpt::maps::CMetricMap* CTerrainGridMap2D::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
  const auto& def = dynamic_cast<const TMapDefinition&>(definition);
  auto map = std::make_unique<CTerrainGridMap2D>(def.creationOpts.resolution, def.terrainOpts);
  map->warnings().rememberWith(def.said);
  map->maxGridCells = def.creationOpts.maxGridCells;
  map->terrainInsertionOptions = def.terrainInsertionOpts;
  map->likelihoodOptions = def.likelihoodOpts;
  map->renderingOptions = def.renderOpts;
  return map.release();
}

}  // namespace mrpt_mapconv
