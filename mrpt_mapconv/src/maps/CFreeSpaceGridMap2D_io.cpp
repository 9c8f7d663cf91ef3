#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/freespace/DropEdges.h>
#include <mrpt_mapconv/freespace/LayerFiles.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/GridSaving.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <stdexcept>

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

  // The tree's own resolution and sensor model: OctoMap's format rounds the one and lacks the
  // other.
  voxel::TVoxelInsertionOptions model;
  model.adoptFrom(*m_octree);
  model.writeToStream(out);
  out << m_octree->getResolution();
  out << voxel::fullOctree(*m_octree);

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

  read.readOctree(in);
  Base::operator=(read);
  setCellSize(read.cellSize());
  voxelInsertionOptions = read.voxelInsertionOptions;
  renderingOptions = read.renderingOptions;
  m_conversion = read.m_conversion;
  m_octree = std::move(read.m_octree);
  m_layers = std::move(read.m_layers);
  m_pending.clear();
  m_sawFree = false;
  forgetTimes();
}

void CFreeSpaceGridMap2D::readOctree(mrpt::serialization::CArchive& in)
{
  voxel::TVoxelInsertionOptions model;
  double resolution = 0;
  std::string bytes;
  grid::GridFrame frame;
  bool empty = true;
  model.readFromStream(in);
  in >> resolution >> bytes >> frame.x0 >> frame.y0 >> frame.width >> frame.height >> empty;

  auto tree = voxel::readOctree(bytes, "CFreeSpaceGridMap2D stream");
  if (!dynamic_cast<octomap::OcTree*>(tree.get()))
    throw std::runtime_error("CFreeSpaceGridMap2D stream: holds a " + tree->getTreeType() +
                             " where an OcTree belongs");
  if (!(std::abs(tree->getResolution() / resolution - 1) < 1e-5))
    throw std::runtime_error("CFreeSpaceGridMap2D stream: two different resolutions");
  setCellSize(resolution);
  m_octree.reset(static_cast<octomap::OcTree*>(tree.release()));
  m_octree->setResolution(resolution);
  model.applyTo(*m_octree);

  const voxel::OctreeSource<octomap::OcTree> source(*m_octree);
  frame.resolution = resolution;
  m_layers = freespace::IncrementalLayers(m_conversion.params);
  if (const auto known = source.bounds())
    m_layers.rebuild(source, unite(frame, voxel::frameOf(*known, resolution)));
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
  files::writeFile(out.path(name + ".ot"), voxel::fullOctree(*m_octree));
}

}  // namespace mrpt_mapconv
