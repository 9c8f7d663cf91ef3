#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/maps/GridInsertionOptions.h>
#include <mrpt_mapconv/maps/GridLikelihoodOptions.h>

#include "MapSections.h"

IMPLEMENTS_SERIALIZABLE(CScanShapeGridMap2D, COccupancyGridMap2D, mrpt_mapconv)

//  ===== MRPT's map factory: a static of this file registers the class as the library is loaded
//  =====
MAP_DEFINITION_REGISTER("mrpt_mapconv::CScanShapeGridMap2D,scanShapeGrid",
                        mrpt_mapconv::CScanShapeGridMap2D)

namespace mrpt_mapconv
{
namespace
{
const std::vector<std::string> kSections{"_creationOpts", "_insertOpts", "_likelihoodOpts"};
}  // namespace

CScanShapeGridMap2D::TMapDefinition::TMapDefinition() = default;

void CScanShapeGridMap2D::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& sectionNamePrefix)
{
  params::StrictSection creation(source, sectionNamePrefix + kSections[0]);
  params::readFields(creation, creationOpts);
  if (!grid::isResolution(creationOpts.resolution))
    creation.fail("resolution", grid::kRightResolution);
  if (creationOpts.maxGridCells < 1) creation.fail("maxGridCells", ">= 1");
  maps::readSharedParams(creation, genericMapParams);
  creation.warnUnknown();

  params::StrictSection insertion(source, sectionNamePrefix + kSections[1]);
  scanInsertionOpts.readFrom(insertion, creationOpts.resolution);
  maps::readGridInsertionOptions(insertion, insertionOpts);
  insertion.warnUnknown();

  maps::loadGridLikelihoodOptions(source, sectionNamePrefix + kSections[2], likelihoodOpts);
  maps::warnUnknownSections(source, sectionNamePrefix, kSections);
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
  map->m_warnings.rememberWith(def.said);
  map->maxGridCells = def.creationOpts.maxGridCells;
  map->scanInsertionOptions = def.scanInsertionOpts;
  map->insertionOptions = def.insertionOpts;
  map->likelihoodOptions = def.likelihoodOpts;
  return map.release();
}

}  // namespace mrpt_mapconv
