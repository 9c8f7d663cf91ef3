#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/LayerFiles.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv
{
using Base = mrpt::maps::COccupancyGridMap2D;

uint8_t CFreeSpaceGridMap2D::serializeGetVersion() const { return 0; }

/** The base class's options, in its own stream format, and those that this format leaves out. The
 * grid itself is not written: it follows from the octree. */
void CFreeSpaceGridMap2D::writeBaseOptions(mrpt::serialization::CArchive& out) const
{
  Base carrier(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f);
  carrier.insertionOptions = insertionOptions;
  carrier.likelihoodOptions = likelihoodOptions;
  carrier.genericMapParams = genericMapParams;
  out << carrier << likelihoodOptions.LF_useSquareDist
      << insertionOptions.maxFreenessUpdateCertainty << insertionOptions.maxFreenessInvalidRanges;
}

void CFreeSpaceGridMap2D::readBaseOptions(mrpt::serialization::CArchive& in)
{
  Base carrier;
  in >> carrier >> carrier.likelihoodOptions.LF_useSquareDist >>
      carrier.insertionOptions.maxFreenessUpdateCertainty >>
      carrier.insertionOptions.maxFreenessInvalidRanges;
  insertionOptions = carrier.insertionOptions;
  likelihoodOptions = carrier.likelihoodOptions;
  genericMapParams = carrier.genericMapParams;
}

void CFreeSpaceGridMap2D::serializeTo(mrpt::serialization::CArchive& out) const
{
  writeBaseOptions(out);
  voxelInsertionOptions.writeToStream(out);
  m_conversion.writeToStream(out);
  out << renderingOptions.showFloor << renderingOptions.showCeiling
      << renderingOptions.colorBySlope;

  const grid::GridFrame& frame = m_layers.layers().frame();
  out << frame.x0 << frame.y0 << frame.width << frame.height << m_is_empty;
  std::ostringstream octree;
  m_octree->write(octree);
  out << octree.str();
}

/** Everything is read into another map first, so a bad stream leaves this one as it was. */
void CFreeSpaceGridMap2D::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
  if (version != 0) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  CFreeSpaceGridMap2D read;
  read.readBaseOptions(in);
  read.voxelInsertionOptions.readFromStream(in);
  read.m_conversion.readFromStream(in);
  in >> read.renderingOptions.showFloor >> read.renderingOptions.showCeiling >>
      read.renderingOptions.colorBySlope;

  grid::GridFrame frame;
  bool empty = true;
  std::string octree;
  in >> frame.x0 >> frame.y0 >> frame.width >> frame.height >> empty >> octree;
  read.readOctree(octree, frame);
  read.m_is_empty = empty;
  Base::operator=(read);
  voxelInsertionOptions = read.voxelInsertionOptions;
  renderingOptions = read.renderingOptions;
  m_conversion = read.m_conversion;
  m_octree = std::move(read.m_octree);
  m_layers = std::move(read.m_layers);
}

void CFreeSpaceGridMap2D::readOctree(const std::string& bytes, grid::GridFrame frame)
{
  auto tree = voxel::readOctree(bytes, "CFreeSpaceGridMap2D stream");
  if (!dynamic_cast<octomap::OcTree*>(tree.get()))
    throw std::runtime_error("CFreeSpaceGridMap2D stream: holds a " + tree->getTreeType() +
                             " where an OcTree belongs");
  m_octree.reset(static_cast<octomap::OcTree*>(tree.release()));
  voxelInsertionOptions.applyTo(*m_octree);

  const voxel::OctreeSource<octomap::OcTree> source(*m_octree);
  frame.resolution = m_octree->getResolution();
  m_layers = freespace::IncrementalLayers(m_conversion.params);
  if (const auto known = source.bounds())
  {
    if (!frame.containsKey(known->xMin, known->yMin) ||
        !frame.containsKey(known->xMax, known->yMax))
      throw std::runtime_error("CFreeSpaceGridMap2D stream: the frame does not hold the voxels");
    m_layers.rebuild(source, frame);
  }
  showAllCells();
}

void CFreeSpaceGridMap2D::saveMetricMapRepresentationToFile(const std::string& prefix) const
{
  Base::saveMetricMapRepresentationToFile(prefix);
  const auto layers = exactLayers();
  if (layers.frame().empty()) return;
  maps::writeLayersTiff(prefix + "_layers.tif", layers);
  for (const auto& [name, layer] : layers.named())
    maps::writeLayerPicture(prefix + "_" + name + ".png", layers, name);
  if (!m_octree->write(prefix + ".ot")) throw std::runtime_error(prefix + ".ot: cannot be written");
}

}  // namespace mrpt_mapconv
