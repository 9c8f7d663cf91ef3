#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv
{
using Base = mrpt::maps::COccupancyGridMap2D;
using Source = voxel::OctreeSource<octomap::OcTree>;

namespace
{
double checkedResolution(double resolution)
{
  if (!std::isfinite(resolution) || resolution <= 0)
    throw std::invalid_argument("resolution = " + std::to_string(resolution) +
                                " is not valid: it must be > 0 m");
  return resolution;
}
}  // namespace

CFreeSpaceGridMap2D::CFreeSpaceGridMap2D(double resolution)
    : m_log("CFreeSpaceGridMap2D"),
      m_warnings(&m_log),
      m_octree(std::make_unique<octomap::OcTree>(checkedResolution(resolution)))
{
  voxelInsertionOptions.applyTo(*m_octree);
  internal_clear();
}

CFreeSpaceGridMap2D::~CFreeSpaceGridMap2D() = default;

CFreeSpaceGridMap2D::CFreeSpaceGridMap2D(const CFreeSpaceGridMap2D& o)
    : Base(o),
      voxelInsertionOptions(o.voxelInsertionOptions),
      renderingOptions(o.renderingOptions),
      m_log("CFreeSpaceGridMap2D"),
      m_warnings(&m_log),
      m_conversion(o.m_conversion),
      m_octree(std::make_unique<octomap::OcTree>(*o.m_octree)),
      m_layers(o.m_layers)
{
}

CFreeSpaceGridMap2D& CFreeSpaceGridMap2D::operator=(const CFreeSpaceGridMap2D& o)
{
  if (this == &o) return *this;
  auto octree = std::make_unique<octomap::OcTree>(*o.m_octree);
  Base::operator=(o);
  voxelInsertionOptions = o.voxelInsertionOptions;
  renderingOptions = o.renderingOptions;
  m_conversion = o.m_conversion;
  m_octree = std::move(octree);
  m_layers = o.m_layers;
  return *this;
}

void CFreeSpaceGridMap2D::setConversionOptions(const maps::TConversionOptions& options)
{
  freespace::IncrementalLayers layers(options.params);
  if (!m_layers.layers().frame().empty())
    layers.rebuild(Source(*m_octree), m_layers.layers().frame());
  m_conversion = options;
  m_layers = std::move(layers);
  showAllCells();
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
  freespace::IncrementalLayers layers(m_conversion.params);
  layers.rebuild(Source(*tree));

  // The tree knows best what it was made with; the next scan goes in likewise.
  voxelInsertionOptions.occupancyThres = tree->getOccupancyThres();
  voxelInsertionOptions.probHit = tree->getProbHit();
  voxelInsertionOptions.probMiss = tree->getProbMiss();
  voxelInsertionOptions.clampingThresMin = tree->getClampingThresMin();
  voxelInsertionOptions.clampingThresMax = tree->getClampingThresMax();
  m_octree = std::move(tree);
  m_layers = std::move(layers);
  showAllCells();
}

void CFreeSpaceGridMap2D::loadVoxelMap(const std::string& file)
{
  auto tree = voxel::readOctreeFile(file);
  if (dynamic_cast<octomap::OcTree*>(tree.get()))
    setVoxelMap(std::unique_ptr<octomap::OcTree>(static_cast<octomap::OcTree*>(tree.release())));
  else
    setVoxelMap(maps::toOcTree(*tree));
}

void CFreeSpaceGridMap2D::internal_clear()
{
  m_octree->clear();
  m_layers = freespace::IncrementalLayers(m_conversion.params);
  showAllCells();
}

bool CFreeSpaceGridMap2D::internal_insertObservation(
    const mrpt::obs::CObservation& obs, const std::optional<const mrpt::poses::CPose3D>& robotPose)
{
  if (!maps::isScan(obs)) return false;
  if (!maps::is3DScan(obs) && !voxelInsertionOptions.insert2D) return false;
  voxelInsertionOptions.check();
  const auto scan =
      maps::sensorPoints(obs, robotPose.value_or(mrpt::poses::CPose3D()), &m_warnings);
  if (!scan || scan->points.empty()) return false;

  // A scan that the layers could not hold must not get into the octree.
  freespace::checkFrameSize(
      unite(m_layers.layers().frame(), maps::frameOfScan(*m_octree, *scan, voxelInsertionOptions)));
  const auto changed = maps::insertScan(*m_octree, *scan, voxelInsertionOptions, &m_warnings);
  const bool laidOutAnew = m_layers.update(Source(*m_octree), changed);
  if (laidOutAnew || !gridFitsLayers())
    showAllCells();
  else
    showCells(freespace::columnsDependingOn(changed, m_conversion.params));
  return true;
}

/** The layer that the grid shows. */
const grid::Layer<float>& CFreeSpaceGridMap2D::occupancy() const
{
  return m_conversion.robot == maps::Robot::Ground ? m_layers.layers().ground
                                                   : m_layers.layers().aerial;
}

/** False if someone has resized the base class's grid, which MRPT's particle filter does. */
bool CFreeSpaceGridMap2D::gridFitsLayers() const
{
  const grid::GridFrame& frame = m_layers.layers().frame();
  return getSizeX() == static_cast<unsigned>(frame.width) &&
         getSizeY() == static_cast<unsigned>(frame.height) &&
         std::abs(getXMin() - frame.xMin()) < 0.5 * frame.resolution &&
         std::abs(getYMin() - frame.yMin()) < 0.5 * frame.resolution;
}

void CFreeSpaceGridMap2D::showAllCells()
{
  m_likelihoodCacheOutDated = true;
  if (!m_layers.layers().frame().empty())
  {
    grid::copyToGridMap(occupancy(), *this);
    return;
  }
  constexpr float cells = 10;  // MRPT's grids are never without cells
  const auto half = static_cast<float>(cells * m_octree->getResolution());
  setSize(-half, half, -half, half, static_cast<float>(m_octree->getResolution()));
  m_is_empty = true;
}

void CFreeSpaceGridMap2D::showCells(const voxel::ColumnSet& columns)
{
  m_likelihoodCacheOutDated = true;
  const auto& layer = occupancy();
  const grid::GridFrame& frame = layer.frame();
  const auto inside = columns.clipped(frame);
  for (const auto& [key, mask] : inside.blocks())
    for (std::int32_t y = 0; y < voxel::kBlockSide; ++y)
      for (std::uint32_t row = mask[static_cast<std::size_t>(y)]; row; row &= row - 1)
      {
        const auto index = frame.indexOfKey(key.x * voxel::kBlockSide + __builtin_ctz(row),
                                            key.y * voxel::kBlockSide + y);
        m_map[index] = grid::rawGridCell(layer.cells()[index]);
      }
}

std::string CFreeSpaceGridMap2D::asString() const
{
  return mrpt::format("Free-space grid map of %zu octree nodes; %s", m_octree->size(),
                      Base::asString().c_str());
}

void CFreeSpaceGridMap2D::getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const
{
  if (!genericMapParams.enableSaveAs3DObject) return;
  const auto layers = exactLayers();
  if (layers.frame().empty()) return;
  const auto& shown = m_conversion.robot == maps::Robot::Ground ? layers.ground : layers.aerial;
  maps::drawOccupancy(shown, maps::heightBelow(layers), !renderingOptions.showFloor, scene);
  maps::drawLayers(layers, renderingOptions, scene);
}

}  // namespace mrpt_mapconv
