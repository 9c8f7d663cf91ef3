#include <mrpt/system/CTicTac.h>
#include <mrpt/system/CTimeLogger.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "MapSections.h"

namespace mrpt_mapconv
{
using Base = mrpt::maps::COccupancyGridMap2D;
using Source = voxel::OctreeSource<octomap::OcTree>;

CFreeSpaceGridMap2D::CFreeSpaceGridMap2D(double resolution)
    : m_log("CFreeSpaceGridMap2D"),
      m_warnings(&m_log),
      m_octree(std::make_unique<octomap::OcTree>(maps::checkedResolution(resolution)))
{
  voxelInsertionOptions.applyTo(*m_octree);
  showAllCells();
}

CFreeSpaceGridMap2D::~CFreeSpaceGridMap2D() { forgetTimes(); }

CFreeSpaceGridMap2D::CFreeSpaceGridMap2D(const CFreeSpaceGridMap2D& o)
    : Base(withRestoredGrid(o)),
      voxelInsertionOptions(o.voxelInsertionOptions),
      renderingOptions(o.renderingOptions),
      m_log("CFreeSpaceGridMap2D"),
      m_warnings(&m_log),
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
  Base::operator=(withRestoredGrid(o));
  voxelInsertionOptions = o.voxelInsertionOptions;
  renderingOptions = o.renderingOptions;
  m_conversion = o.m_conversion;
  m_octree = std::move(octree);
  m_layers = o.m_layers;
  m_pending = o.m_pending;
  m_sawFree = o.m_sawFree;
  forgetTimes();
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

bool CFreeSpaceGridMap2D::internal_insertObservation(
    const mrpt::obs::CObservation& obs, const std::optional<const mrpt::poses::CPose3D>& robotPose)
{
  if (!observation::isScan(obs)) return false;
  if (!observation::is3DScan(obs) && !voxelInsertionOptions.insert2D) return false;
  voxelInsertionOptions.check();
  const mrpt::system::CTicTac watch;
  const auto scan =
      observation::sensorPoints(obs, robotPose.value_or(mrpt::poses::CPose3D()), &m_warnings);
  if (!scan || scan->points.empty()) return false;

  // A scan that the layers or MRPT's grid could not hold must not get into the octree.
  const grid::GridFrame needed =
      unite(m_layers.layers().frame(), voxel::frameOfScan(*m_octree, *scan, voxelInsertionOptions));
  freespace::checkFrameSize(needed);
  grid::checkGridMapFrame(needed);
  const double prepared = watch.Tac();
  m_pending.insert(voxel::insertScan(*m_octree, *scan, voxelInsertionOptions, &m_warnings));
  const double inserted = watch.Tac();
  const std::size_t columns = m_pending.size();
  const bool laidOut = followOctree();
  warnIfNothingIsFree();
  const double shown = watch.Tac();

  auto& log = times();
  log.registerUserMeasure("insert", shown, true);
  log.registerUserMeasure("insert.voxels", inserted - prepared, true);
  log.registerUserMeasure("insert.layers", shown - inserted, true);
  log.registerUserMeasure("insert.columns", static_cast<double>(columns));
  log.registerUserMeasure("insert.laidOut", laidOut ? 1 : 0);
  return true;
}

/** Converts the pending columns. Should it fail, for want of memory say, they stay pending.
 * \return true if everything was laid out anew */
bool CFreeSpaceGridMap2D::followOctree()
{
  const bool laidOut = m_layers.update(Source(*m_octree), m_pending) || !gridFitsLayers();
  if (laidOut)
    showAllCells();
  else
    showCells(freespace::columnsDependingOn(m_pending, m_conversion.params));
  m_pending.clear();
  return laidOut;
}

const mrpt::system::CTimeLogger& CFreeSpaceGridMap2D::insertionTimes() const { return times(); }

mrpt::system::CTimeLogger& CFreeSpaceGridMap2D::times() const
{
  constexpr bool enabled = true, wholeHistory = true;
  const std::lock_guard<std::mutex> lock(m_lazy);
  if (!m_times)
    m_times =
        std::make_unique<mrpt::system::CTimeLogger>(enabled, "CFreeSpaceGridMap2D", wholeHistory);
  return *m_times;
}

void CFreeSpaceGridMap2D::forgetTimes()
{
  if (m_times) m_times->clear(true);  // or MRPT prints it
  m_times.reset();
}

/** An entirely unknown map is most often one whose scans leave gaps between their beams. */
void CFreeSpaceGridMap2D::warnIfNothingIsFree()
{
  if (m_sawFree) return;
  const auto& aerial = m_layers.layers().aerial.cells();
  m_sawFree = std::any_of(aerial.begin(), aerial.end(), grid::isFree);
  if (m_sawFree || aerial.empty()) return;
  m_warnings.warnOnce(mrpt::format(
      "voxels are known, but no free range is minClearance = %g m high: all cells are unknown",
      m_conversion.params.minClearance));
}

/** The layer that the grid shows. */
const grid::Layer<float>& CFreeSpaceGridMap2D::occupancy() const
{
  return m_conversion.robot == freespace::Robot::Ground ? m_layers.layers().ground
                                                        : m_layers.layers().aerial;
}

/** False if someone has resized the base class's grid, which MRPT's particle filter does. */
bool CFreeSpaceGridMap2D::gridFitsLayers() const
{
  const grid::GridFrame& frame = m_layers.layers().frame();
  return getSizeX() == static_cast<unsigned>(frame.width) &&
         getSizeY() == static_cast<unsigned>(frame.height) &&
         std::abs(getResolution() - frame.resolution) < 1e-6 * frame.resolution &&
         std::abs(getXMin() - frame.xMin()) < 0.5 * frame.resolution &&
         std::abs(getYMin() - frame.yMin()) < 0.5 * frame.resolution;
}

/** Lays the grid out anew if someone has resized it. A map without layers has nothing to lay out;
 * its grid may hold what MRPT's particle filter has averaged into it. */
void CFreeSpaceGridMap2D::restoreGrid() const
{
  const std::lock_guard<std::mutex> lock(m_lazy);
  if (m_layers.layers().frame().empty() || gridFitsLayers()) return;
  // No constructor leaves a grid that does not fit, so whoever has resized this one since had a map
  // that is not const.
  const_cast<CFreeSpaceGridMap2D*>(this)->showAllCells();
}

/** A map to copy the grid of, so that no copy, which may be const, begins with a resized grid. */
const CFreeSpaceGridMap2D& CFreeSpaceGridMap2D::withRestoredGrid(const CFreeSpaceGridMap2D& map)
{
  map.restoreGrid();
  return map;
}

void CFreeSpaceGridMap2D::determineMatching2D(const mrpt::maps::CMetricMap* otherMap,
                                              const mrpt::poses::CPose2D& otherMapPose,
                                              mrpt::tfest::TMatchingPairList& correspondences,
                                              const mrpt::maps::TMatchingParams& params,
                                              mrpt::maps::TMatchingExtraResults& extraResults) const
{
  restoreGrid();
  Base::determineMatching2D(otherMap, otherMapPose, correspondences, params, extraResults);
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
  const auto& shown =
      m_conversion.robot == freespace::Robot::Ground ? layers.ground : layers.aerial;
  freespace::drawOccupancy(shown, freespace::heightBelow(layers), !renderingOptions.showFloor,
                           scene);
  freespace::drawLayers(layers, renderingOptions, scene);
}

}  // namespace mrpt_mapconv
