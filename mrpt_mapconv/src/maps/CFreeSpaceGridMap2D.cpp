#include <mrpt/system/CTicTac.h>
#include <mrpt/system/CTimeLogger.h>
#include <mrpt_mapconv/freespace/RobotLayers.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/MapDefinition.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv
{
using Source = voxel::OctreeSource<octomap::OcTree>;

CFreeSpaceGridMap2D::CFreeSpaceGridMap2D(double resolution)
    : LayerGridMap2D("CFreeSpaceGridMap2D", resolution),
      m_octree(std::make_unique<octomap::OcTree>(resolution))
{
  voxelInsertionOptions.applyTo(*m_octree);
}

CFreeSpaceGridMap2D::~CFreeSpaceGridMap2D() = default;

CFreeSpaceGridMap2D::CFreeSpaceGridMap2D(const CFreeSpaceGridMap2D& o)
    : LayerGridMap2D(o),
      voxelInsertionOptions(o.voxelInsertionOptions),
      renderingOptions(o.renderingOptions),
      m_conversion(o.m_conversion),
      m_octree(std::make_unique<octomap::OcTree>(*o.m_octree)),
      m_layers(o.m_layers),
      m_pending(o.m_pending),
      m_sawFree(o.m_sawFree)
{
}

CFreeSpaceGridMap2D& CFreeSpaceGridMap2D::operator=(const CFreeSpaceGridMap2D& o)
{
  if (this == &o) return *this;
  auto octree = std::make_unique<octomap::OcTree>(*o.m_octree);
  LayerGridMap2D::operator=(o);
  voxelInsertionOptions = o.voxelInsertionOptions;
  renderingOptions = o.renderingOptions;
  m_conversion = o.m_conversion;
  m_octree = std::move(octree);
  m_layers = o.m_layers;
  m_pending = o.m_pending;
  m_sawFree = o.m_sawFree;
  return *this;
}

void CFreeSpaceGridMap2D::setConversionOptions(const freespace::TConversionOptions& options)
{
  freespace::IncrementalLayers layers(options.params);
  if (!m_layers.layers().frame().empty())
    layers.rebuild(Source(*m_octree), m_layers.layers().frame());
  m_conversion = options;
  m_layers = std::move(layers);
  m_sawFree = false;
  showAllCells();
  warnIfNothingIsFree();
}

freespace::Layers CFreeSpaceGridMap2D::exactLayers() const
{
  return m_layers.exact(Source(*m_octree));
}

void CFreeSpaceGridMap2D::setVoxelMap(const octomap::OcTree& tree)
{
  setVoxelMap(std::make_unique<octomap::OcTree>(tree));
}

void CFreeSpaceGridMap2D::setVoxelMap(const mrpt::maps::COctoMap& map)
{
  setVoxelMap(maps::octreeOf(map));
}

void CFreeSpaceGridMap2D::setVoxelMap(std::unique_ptr<octomap::OcTree> tree)
{
  if (!tree) throw std::invalid_argument("setVoxelMap: no octree given");
  takeOctree(std::move(tree));
  voxelInsertionOptions.adoptFrom(*m_octree);
}

void CFreeSpaceGridMap2D::loadVoxelMap(const std::string& file)
{
  voxelInsertionOptions.check();
  auto read = voxel::readOctreeFile(file);
  std::unique_ptr<octomap::OcTree> tree;
  if (dynamic_cast<octomap::OcTree*>(read.get()))
    tree.reset(static_cast<octomap::OcTree*>(read.release()));
  else
    tree = voxel::toOcTree(*read);
  voxelInsertionOptions.applyTo(*tree);
  takeOctree(std::move(tree));
}

/** Converts a tree and, if that succeeds, makes it the map's. */
void CFreeSpaceGridMap2D::takeOctree(std::unique_ptr<octomap::OcTree> tree)
{
  maps::checkedResolution(tree->getResolution());
  freespace::IncrementalLayers layers(m_conversion.params);
  layers.rebuild(Source(*tree));
  if (!layers.layers().frame().empty()) grid::checkGridMapFrame(layers.layers().frame());
  setCellSize(tree->getResolution());
  m_octree = std::move(tree);
  m_layers = std::move(layers);
  m_pending.clear();
  m_sawFree = false;
  showAllCells();
  warnIfNothingIsFree();
}

void CFreeSpaceGridMap2D::internal_clear()
{
  m_octree->clear();
  m_layers = freespace::IncrementalLayers(m_conversion.params);
  m_pending.clear();
  m_sawFree = false;
  showAllCells();
}

std::string CFreeSpaceGridMap2D::insertScan(const observation::SensorPoints& scan)
{
  // A scan that the layers or MRPT's grid could not hold must not get into the octree.
  const grid::GridFrame needed =
      unite(layers().frame(), voxel::frameOfScan(*m_octree, scan, voxelInsertionOptions));
  freespace::checkFrameSize(needed);
  grid::checkGridMapFrame(needed);
  const mrpt::system::CTicTac watch;
  m_pending.insert(voxel::insertScan(*m_octree, scan, voxelInsertionOptions, &warnings()));
  const double inserted = watch.Tac();
  const std::size_t columns = m_pending.size();
  const bool laidOut = followOctree();
  warnIfNothingIsFree();

  auto& log = times();
  log.registerUserMeasure("insert.voxels", inserted, true);
  log.registerUserMeasure("insert.layers", watch.Tac() - inserted, true);
  log.registerUserMeasure("insert.columns", static_cast<double>(columns));
  log.registerUserMeasure("insert.laidOut", laidOut ? 1 : 0);
  return "";
}

/** Converts the pending columns. Should it fail, for want of memory say, they stay pending.
 * \return true if everything was laid out anew */
bool CFreeSpaceGridMap2D::followOctree()
{
  const auto change = m_layers.update(Source(*m_octree), m_pending);
  const bool laidOut =
      showCells(change.everywhere ? voxel::ColumnSet::of(layers().frame()) : change.columns);
  m_pending.clear();
  return change.everywhere || laidOut;
}

/** An entirely unknown map is most often one whose scans leave gaps between their beams. */
void CFreeSpaceGridMap2D::warnIfNothingIsFree()
{
  if (m_sawFree) return;
  const auto& aerial = layers().aerial.cells();
  m_sawFree = std::any_of(aerial.begin(), aerial.end(), grid::isFree);
  if (m_sawFree || aerial.empty()) return;
  if (!voxel::hasFreeVoxel(Source(*m_octree)) &&
      m_conversion.params.reading.unknown == voxel::Unknown::Unknown)
    return warnings().warnOnce(
        "voxels are known, but none is free, as in maps made of clouds or meshes: all cells are "
        "unknown; unknown = free, a conversion option, takes what is above occupied voxels for "
        "free");
  warnings().warnOnce(mrpt::format(
      "voxels are known, but no free range is minClearance = %g m high: all cells are unknown",
      m_conversion.params.minClearance));
}

const grid::Layer<float>& CFreeSpaceGridMap2D::shownOf(const freespace::Layers& layers) const
{
  return freespace::occupancyFor(layers, m_conversion.robot);
}

std::string CFreeSpaceGridMap2D::asString() const
{
  return mrpt::format("Free-space grid map of %zu octree nodes; %s", m_octree->size(),
                      LayerGridMap2D::asString().c_str());
}

void CFreeSpaceGridMap2D::drawLayers(mrpt::opengl::CSetOfObjects& scene) const
{
  const auto layers = exactLayers();
  const double below = grid::heightBelow(layers.floor);
  grid::drawOccupancy(shownOf(layers), below, !renderingOptions.showFloor, scene);
  freespace::drawFreeSpace(layers, renderingOptions, scene);
}

}  // namespace mrpt_mapconv
