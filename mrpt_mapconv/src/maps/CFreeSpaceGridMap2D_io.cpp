#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/freespace/DropEdges.h>
#include <mrpt_mapconv/freespace/LayerFiles.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/GridSaving.h>

namespace mrpt_mapconv
{
using Base = mrpt::maps::COccupancyGridMap2D;

uint8_t CFreeSpaceGridMap2D::serializeGetVersion() const { return 0; }

void CFreeSpaceGridMap2D::serializeTo(mrpt::serialization::CArchive& out) const
{
  maps::writeGridOptions(out, *this);
  voxelInsertionOptions.writeToStream(out);
  m_conversion.writeToStream(out);
  params::writeFields(renderingOptions, out);

  // The voxels' own resolution and sensor model: OctoMap's format rounds the one and lacks the
  // other.
  voxel::TVoxelInsertionOptions model;
  model.adoptModel(m_voxels.model());
  model.pruning = m_voxels.model().pruning;
  model.writeToStream(out);
  out << m_voxels.resolution();
  out << m_voxels.fullOctree();

  const grid::GridFrame& frame = m_layers.layers().frame();
  out << frame.x0 << frame.y0 << frame.width << frame.height << m_is_empty;
}

/** Everything is read into another map first, so a bad stream leaves this one as it was. */
void CFreeSpaceGridMap2D::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
  if (version != 0) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  CFreeSpaceGridMap2D read;
  maps::readGridOptions(in, read);
  read.voxelInsertionOptions.readFromStream(in);
  read.m_conversion.readFromStream(in);
  params::readFields(in, read.renderingOptions, version, "CFreeSpaceGridMap2D stream");

  read.readVoxels(in);
  Base::operator=(read);
  setCellSize(read.cellSize());
  voxelInsertionOptions = read.voxelInsertionOptions;
  renderingOptions = read.renderingOptions;
  m_conversion = read.m_conversion;
  m_voxels = std::move(read.m_voxels);
  m_layers = std::move(read.m_layers);
  m_pending.clear();
  m_sawFree = false;
  forgetTimes();
}

void CFreeSpaceGridMap2D::readVoxels(mrpt::serialization::CArchive& in)
{
  voxel::TVoxelInsertionOptions model;
  double resolution = 0;
  std::string bytes;
  grid::GridFrame frame;
  bool empty = true;
  model.readFromStream(in);
  in >> resolution >> bytes >> frame.x0 >> frame.y0 >> frame.width >> frame.height >> empty;

  setCellSize(resolution);
  m_voxels.setModel(model);
  m_voxels.setFullOctree(bytes, "CFreeSpaceGridMap2D stream", resolution,
                         voxelInsertionOptions.maxMemory);
  const auto source = m_voxels.source();
  frame.resolution = resolution;
  m_layers = freespace::IncrementalLayers(m_conversion.params);
  if (const auto known = source->bounds())
    m_layers.rebuild(*source, unite(frame, voxel::frameOf(*known, resolution)));
  showAllCells();
  m_is_empty = empty;
}

void CFreeSpaceGridMap2D::saveLayers(files::OutputDir& out, const std::string& name) const
{
  const auto layers = exactLayers();
  grid::ExportFormats formats{name + "_layers.tif", freespace::metadataOf(m_conversion.params)};
  formats.prefix = name + "_";
  formats.pictures = true;
  const auto edges = freespace::dropEdges(layers, m_conversion.params);
  grid::exportLayers(out, layers.styled(edges), formats);
  files::writeFile(out.path(name + ".ot"), m_voxels.fullOctree());
}

}  // namespace mrpt_mapconv
