#include <mrpt_mapconv/maps/CTerrainGridMap2D.h>
#include <mrpt_mapconv/maps/GridSaving.h>
#include <mrpt_mapconv/terrain/TerrainFiles.h>

namespace mrpt_mapconv
{
uint8_t CTerrainGridMap2D::serializeGetVersion() const { return 0; }

void CTerrainGridMap2D::serializeTo(mrpt::serialization::CArchive& out) const
{
  maps::writeGridOptions(out, *this);
  terrainInsertionOptions.writeToStream(out);
  terrain::TTerrainOptions options;
  options.params = m_terrain.params();
  options.writeToStream(out);
  params::writeFields(renderingOptions, out);
  out << maxGridCells << cellSize();
  m_terrain.save(out);
  out << m_is_empty;
}

/** Everything is read into another map first, so a bad stream leaves this one as it was. */
void CTerrainGridMap2D::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
  if (version != 0) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  CTerrainGridMap2D read;
  maps::readGridOptions(in, read);
  read.terrainInsertionOptions.readFromStream(in);
  terrain::TTerrainOptions options;
  options.readFromStream(in);
  params::readFields(in, read.renderingOptions, version, "CTerrainGridMap2D stream");
  double resolution = 0;
  bool empty = true;
  in >> read.maxGridCells >> resolution;
  read.setCellSize(resolution);
  read.m_terrain = terrain::TerrainMap(resolution, options.params);
  read.m_terrain.load(in);
  in >> empty;
  read.showTerrain();
  read.m_is_empty = empty;
  *this = read;
}

void CTerrainGridMap2D::saveLayers(files::OutputDir& out, const std::string& name) const
{
  grid::ExportFormats formats{name + "_layers.tif"};
  formats.prefix = name + "_";
  formats.pictures = true;
  terrain::exportTerrain(out, m_terrain, m_layers, formats);
}

}  // namespace mrpt_mapconv
