#include <mrpt/system/CTicTac.h>
#include <mrpt/system/CTimeLogger.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/maps/CTerrainGridMap2D.h>
#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/terrain/ScanInsertion.h>
#include <mrpt_mapconv/terrain/TerrainFiles.h>
#include <mrpt_mapconv/terrain/TerrainScene.h>

#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv
{
CTerrainGridMap2D::CTerrainGridMap2D(double resolution, const terrain::TTerrainOptions& options)
    : LayerGridMap2D("CTerrainGridMap2D", resolution), m_terrain(resolution, options.params)
{
}

std::vector<grid::StyledLayer> CTerrainGridMap2D::styledLayers() const
{
  return terrain::styled(m_layers);
}

void CTerrainGridMap2D::internal_clear()
{
  m_terrain.clear();
  showTerrain();
}

/** What the layers or MRPT's grid could not hold must not get into the cells. A local window
 * forgets what lies outside of it. */
void CTerrainGridMap2D::checkRoomFor(const grid::GridFrame& needed, bool forgets) const
{
  const auto all = forgets ? needed : unite(m_layers.height.frame(), needed);
  terrain::TerrainGridParams limits{cellSize(), maxGridCells};
  limits.checkSize(all);
  grid::checkGridMapFrame(all);
}

std::string CTerrainGridMap2D::insertScan(const observation::SensorPoints& scan)
{
  if (!observation::isFinite(scan.sensorPose)) return "its pose is not finite";
  const auto& options = terrainInsertionOptions;
  const auto used = terrain::usedPoints(scan, options.limits);
  if (used.points.empty()) return "it has no point within maxRange, minHeight and maxHeight";
  checkRoomFor(terrain::frameOf(used, m_terrain), m_terrain.params().localWindow > 0);
  const mrpt::system::CTicTac watch;
  terrain::insertScan(m_terrain, scan, used, options.sigmas, options.sigmas.poseCovariance());
  const double inserted = watch.Tac();
  m_terrain.update();
  const double updated = watch.Tac();
  showTerrain();

  auto& log = times();
  log.registerUserMeasure("insert.cells", inserted, true);
  log.registerUserMeasure("insert.planes", updated - inserted, true);
  log.registerUserMeasure("insert.layers", watch.Tac() - updated, true);
  return "";
}

void CTerrainGridMap2D::showTerrain()
{
  m_layers = m_terrain.cells() > 0 ? m_terrain.layers() : terrain::TerrainLayers();
  showAllCells();
}

bool CTerrainGridMap2D::insertIndividualPoint(double x, double y, double z,
                                              const TPointInsertParams& params)
{
  if (!std::isfinite(x + y + z)) return false;
  terrain::UsedPoints point;
  point.points.emplace_back();
  point.xMin = point.xMax = x;
  point.yMin = point.yMax = y;
  try
  {
    checkRoomFor(unite(m_terrain.frame(), terrain::frameOf(point, m_terrain)), false);
    m_terrain.insertPoint(
        x, y, z, params.pt_z_std != 0 ? params.pt_z_std : terrainInsertionOptions.sigmas.range);
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
  m_is_empty = false;
  if (params.update_map_after_insertion) dem_update_map();
  return true;
}

void CTerrainGridMap2D::dem_update_map()
{
  m_terrain.update();
  showTerrain();
}

std::size_t CTerrainGridMap2D::dem_get_size_x() const
{
  return static_cast<std::size_t>(m_layers.height.frame().width);
}

std::size_t CTerrainGridMap2D::dem_get_size_y() const
{
  return static_cast<std::size_t>(m_layers.height.frame().height);
}

bool CTerrainGridMap2D::dem_get_z_by_cell(std::size_t cx, std::size_t cy, double& z_out) const
{
  if (cx >= dem_get_size_x() || cy >= dem_get_size_y()) return false;
  const float z = m_layers.height.at(static_cast<std::int32_t>(cx), static_cast<std::int32_t>(cy));
  if (!std::isfinite(z)) return false;
  z_out = static_cast<double>(z);
  return true;
}

bool CTerrainGridMap2D::dem_get_z(double x, double y, double& z_out) const
{
  const auto place = m_terrain.at(x, y);
  if (place) z_out = place->height;
  return place.has_value();
}

maps::SelfDescription CTerrainGridMap2D::describe() const
{
  maps::SelfDescription layers = LayerGridMap2D::describe(), all;
  all.name = "terrain";
  const auto add = [&all](const char* name, std::size_t count)
  {
    all.lines.emplace_back(name, std::to_string(count));
    all.values.emplace_back(name, static_cast<std::int32_t>(count));
  };
  add("knownCells", m_terrain.cells());
  add("leaves", m_terrain.leaves());
  add("planes", m_terrain.planes().size());
  add("steps", m_terrain.steps().size());
  all.lines.insert(all.lines.end(), layers.lines.begin(), layers.lines.end());
  return all;
}

std::string CTerrainGridMap2D::asString() const
{
  return mrpt::format("Terrain grid map of %zu cells in %zu leaves and %zu planes; %s",
                      m_terrain.cells(), m_terrain.leaves(), m_terrain.planes().size(),
                      LayerGridMap2D::asString().c_str());
}

void CTerrainGridMap2D::drawLayers(mrpt::opengl::CSetOfObjects& scene) const
{
  if (!renderingOptions.showLeaves)
    grid::drawOccupancy(m_layers.traversability, grid::heightBelow(m_layers.height), true, scene);
  terrain::drawLeaves(m_terrain, m_layers.plane, renderingOptions, scene);
}

}  // namespace mrpt_mapconv
