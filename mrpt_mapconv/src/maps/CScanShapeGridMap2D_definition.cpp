#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/maps/GridInsertionOptions.h>
#include <mrpt_mapconv/maps/MapDefinition.h>

IMPLEMENTS_SERIALIZABLE(CScanShapeGridMap2D, COccupancyGridMap2D, mrpt_mapconv)

//  ===== MRPT's map factory: a static of this file registers the class as the library is loaded
//  =====
MAP_DEFINITION_REGISTER("mrpt_mapconv::CScanShapeGridMap2D,scanShapeGrid",
                        mrpt_mapconv::CScanShapeGridMap2D)

namespace mrpt_mapconv
{
CScanShapeGridMap2D::TMapDefinition::TMapDefinition() = default;

void CScanShapeGridMap2D::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& sectionNamePrefix)
{
  maps::DefinitionSections ini(source, sectionNamePrefix);
  ini.readCreation(creationOpts, genericMapParams,
                   [this](const params::StrictSection& creation)
                   {
                     if (creationOpts.maxGridCells < 1) creation.fail("maxGridCells", ">= 1");
                   });
  params::StrictSection insertion(source, ini.name("_insertOpts"));
  scanInsertionOpts.readFrom(insertion, creationOpts.resolution);
  maps::readGridInsertionOptions(insertion, insertionOpts);
  insertion.warnUnknown();
  ini.readLikelihood(likelihoodOpts);
  ini.warnUnknown();
}

void CScanShapeGridMap2D::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
  params::printFields(creationOpts, out);
  scanInsertionOpts.dumpToTextStream(out);
  insertionOpts.dumpToTextStream(out);
  likelihoodOpts.dumpToTextStream(out);
}

mrpt::maps::CMetricMap* CScanShapeGridMap2D::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
  const auto& def = dynamic_cast<const TMapDefinition&>(definition);
  auto map = std::make_unique<CScanShapeGridMap2D>(def.creationOpts.resolution);
  map->m_log.warnings.rememberWith(def.said);
  map->maxGridCells = def.creationOpts.maxGridCells;
  map->scanInsertionOptions = def.scanInsertionOpts;
  map->insertionOptions = def.insertionOpts;
  map->likelihoodOptions = def.likelihoodOpts;
  return map.release();
}

}  // namespace mrpt_mapconv
