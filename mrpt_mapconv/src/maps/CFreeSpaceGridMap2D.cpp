#include <mrpt/system/CTicTac.h>
#include <mrpt/system/CTimeLogger.h>
#include <mrpt_mapconv/freespace/DropEdges.h>
#include <mrpt_mapconv/freespace/RobotLayers.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/MapDefinition.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv
{
CFreeSpaceGridMap2D::CFreeSpaceGridMap2D(double resolution)
    : LayerGridMap2D("CFreeSpaceGridMap2D", resolution), m_voxels(resolution)
{
}

CFreeSpaceGridMap2D& CFreeSpaceGridMap2D::operator=(const CFreeSpaceGridMap2D& o)
{
  if (this == &o) return *this;
  voxel::VoxelMap voxels = o.m_voxels;  // what needs much memory comes first
  freespace::IncrementalLayers layers = o.m_layers;
  LayerGridMap2D::operator=(o);
  voxelInsertionOptions = o.voxelInsertionOptions;
  renderingOptions = o.renderingOptions;
  m_conversion = o.m_conversion;
  m_voxels = std::move(voxels);
  m_layers = std::move(layers);
  m_pending = o.m_pending;
  m_sawFree = o.m_sawFree;
  return *this;
}

void CFreeSpaceGridMap2D::setConversionOptions(const freespace::TConversionOptions& options)
{
  freespace::IncrementalLayers layers(options.params);
  if (!m_layers.layers().frame().empty())
    layers.rebuild(*m_voxels.source(), m_layers.layers().frame());
  m_conversion = options;
  m_layers = std::move(layers);
  m_sawFree = false;
  showAllCells();
  warnIfNothingIsFree();
}

freespace::Layers CFreeSpaceGridMap2D::exactLayers() const
{
  return m_layers.exact(*m_voxels.source());
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
  maps::checkedResolution(tree->getResolution());
  voxel::VoxelMap voxels(tree->getResolution());
  voxels.setOctree(std::move(tree));
  takeVoxels(std::move(voxels));
  voxelInsertionOptions.adoptModel(m_voxels.model());
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
  maps::checkedResolution(tree->getResolution());
  voxel::VoxelMap voxels(tree->getResolution());
  voxels.setOctree(std::move(tree));
  voxels.setModel(voxelInsertionOptions);
  takeVoxels(std::move(voxels));
}

/** Converts voxels and, if that succeeds, makes them the map's. */
void CFreeSpaceGridMap2D::takeVoxels(voxel::VoxelMap voxels)
{
  freespace::IncrementalLayers layers(m_conversion.params);
  layers.rebuild(*voxels.source());
  if (!layers.layers().frame().empty()) grid::checkGridMapFrame(layers.layers().frame());
  setCellSize(voxels.resolution());
  m_voxels = std::move(voxels);
  m_layers = std::move(layers);
  m_pending.clear();
  m_sawFree = false;
  showAllCells();
  warnIfNothingIsFree();
}

void CFreeSpaceGridMap2D::internal_clear()
{
  m_voxels.clear();
  m_layers = freespace::IncrementalLayers(m_conversion.params);
  m_pending.clear();
  m_sawFree = false;
  showAllCells();
}

std::string CFreeSpaceGridMap2D::insertScan(const observation::SensorPoints& scan)
{
  // A scan that the layers or MRPT's grid could not hold must not get into the voxel map.
  const auto checkFrame = [this](const grid::GridFrame& frame)
  {
    const grid::GridFrame needed = unite(layers().frame(), frame);
    freespace::checkFrameSize(needed);
    grid::checkGridMapFrame(needed);
  };
  const mrpt::system::CTicTac watch;
  m_pending.insert(m_voxels.insertScan(scan, voxelInsertionOptions, &warnings(), checkFrame));
  const double inserted = watch.Tac();
  const std::size_t columns = m_pending.size();
  const bool laidOut = followVoxels();
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
bool CFreeSpaceGridMap2D::followVoxels()
{
  const auto change = m_layers.update(*m_voxels.source(), m_pending);
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
  if (!m_voxels.hasFree() && m_conversion.params.reading.unknown == voxel::Unknown::Unknown)
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
  return mrpt::format("Free-space grid map of %zu known voxels; %s", m_voxels.size(),
                      LayerGridMap2D::asString().c_str());
}

void CFreeSpaceGridMap2D::drawLayers(mrpt::opengl::CSetOfObjects& scene) const
{
  const auto layers = exactLayers();
  const double below = grid::heightBelow(layers.floor);
  grid::drawOccupancy(shownOf(layers), below, !renderingOptions.showFloor, scene);
  if (m_conversion.robot == freespace::Robot::Aerial)
    return freespace::drawFreeSpace(layers, renderingOptions, scene);
  const auto edges = freespace::dropEdges(layers, m_conversion.params);
  freespace::drawGround(layers, renderingOptions, grid::findLayer(layers.styled(edges), "ground"),
                        scene);
}

}  // namespace mrpt_mapconv
