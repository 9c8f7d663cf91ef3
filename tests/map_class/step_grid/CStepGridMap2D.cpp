#include "CStepGridMap2D.h"

#include <mrpt/core/initializer.h>
#include <mrpt_mapconv/maps/GridSaving.h>
#include <mrpt_mapconv/maps/MapDefinition.h>

IMPLEMENTS_SERIALIZABLE(CStepGridMap2D, COccupancyGridMap2D, step_grid)
MAP_DEFINITION_REGISTER("step_grid::CStepGridMap2D,stepGrid", step_grid::CStepGridMap2D)
MRPT_INITIALIZER(registerStepGrid)
{
  mrpt::rtti::registerClass(CLASS_ID(step_grid::CStepGridMap2D));
}

namespace step_grid
{
using namespace mrpt_mapconv;

CStepGridMap2D::CStepGridMap2D(double resolution)
    : LayerGridMap2D("CStepGridMap2D", resolution), m_layers(resolution)
{
}

std::vector<grid::StyledLayer> CStepGridMap2D::styledLayers() const
{
  return {{"height", &m_layers.lowest, "Lowest point", "m", grid::LayerKind::Height},
          {"occupancy", &m_layers.occupancy, "Steps", "", grid::LayerKind::Occupancy}};
}

void CStepGridMap2D::internal_clear()
{
  m_layers = StepLayers(cellSize());
  showAllCells();
}

std::string CStepGridMap2D::insertScan(const observation::SensorPoints& scan)
{
  std::vector<mrpt::math::TPoint3D> points;
  for (const auto& p : scan.points)
    if (p.norm() <= insertionParams.maxRange)
      points.push_back(scan.sensorPose.composePoint(mrpt::math::TPoint3D(p)));
  if (points.empty()) return "it has no point within maxRange";
  showCells(m_layers.insert(points, insertionParams.maxStep));
  return "";
}

CStepGridMap2D::TMapDefinition::TMapDefinition() = default;

void CStepGridMap2D::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& prefix)
{
  maps::DefinitionSections ini(source, prefix);
  ini.readCreation(creationOpts, genericMapParams);
  insertionOpts.loadFromConfigFile(source, ini.name("_insertOpts"));
  ini.readLikelihood(likelihoodOpts);
  ini.warnUnknown();
}

void CStepGridMap2D::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
  params::printFields(creationOpts, out);
  insertionOpts.dumpToTextStream(out);
  likelihoodOpts.dumpToTextStream(out);
}

mrpt::maps::CMetricMap* CStepGridMap2D::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
  const auto& def = dynamic_cast<const TMapDefinition&>(definition);
  auto map = std::make_unique<CStepGridMap2D>(def.creationOpts.resolution);
  map->warnings().rememberWith(def.said);
  map->insertionParams = def.insertionOpts;
  map->likelihoodOptions = def.likelihoodOpts;
  return map.release();
}

uint8_t CStepGridMap2D::serializeGetVersion() const { return 0; }

void CStepGridMap2D::serializeTo(mrpt::serialization::CArchive& out) const
{
  maps::writeGridOptions(out, *this);
  for (const auto* layer : {&m_layers.lowest, &m_layers.highest, &m_layers.occupancy})
    maps::writeLayer(out, *layer);
  insertionParams.writeToStream(out);
}

void CStepGridMap2D::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
  if (version != 0) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  CStepGridMap2D read;
  maps::readGridOptions(in, read);
  for (auto* layer : {&read.m_layers.lowest, &read.m_layers.highest, &read.m_layers.occupancy})
    maps::readLayer(in, *layer);
  read.setCellSize(read.m_layers.lowest.frame().resolution);
  read.insertionParams.readFromStream(in);
  read.showAllCells();
  *this = read;
}

}  // namespace step_grid
