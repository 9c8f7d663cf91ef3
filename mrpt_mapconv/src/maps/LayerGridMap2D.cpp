#include <mrpt/system/CTicTac.h>
#include <mrpt/system/CTimeLogger.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/maps/GridSaving.h>
#include <mrpt_mapconv/maps/LayerGridMap2D.h>
#include <mrpt_mapconv/maps/MapDefinition.h>

#include <cmath>

namespace mrpt_mapconv::maps
{
using Base = mrpt::maps::COccupancyGridMap2D;

LayerGridMap2D::LayerGridMap2D(const std::string& ownName, double resolution)
    : Base(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f),  // its own default is large
      m_log(ownName),
      m_times(ownName),
      m_cellSize(checkedResolution(resolution))
{
  startEmpty();
}

LayerGridMap2D::LayerGridMap2D(const LayerGridMap2D& o)
    : Base(o), m_log(o.m_log), m_times(o.m_times), m_cellSize(o.m_cellSize)
{
  if (o.mustBeLaidOut()) showAllCellsOf(o.shownLayer());
}

LayerGridMap2D& LayerGridMap2D::operator=(const LayerGridMap2D& o)
{
  if (this == &o) return *this;
  Base::operator=(o);
  m_log = o.m_log;
  m_times = o.m_times;
  m_cellSize = o.m_cellSize;
  if (o.mustBeLaidOut()) showAllCellsOf(o.shownLayer());
  return *this;
}

void LayerGridMap2D::setCellSize(double resolution) { m_cellSize = checkedResolution(resolution); }

bool LayerGridMap2D::internal_insertObservation(
    const mrpt::obs::CObservation& obs, const std::optional<const mrpt::poses::CPose3D>& robotPose)
{
  // a likelihood asks: nothing may change, and MRPT's own grid counts nothing either
  if (updateInfoChangeOnly.enabled) return false;
  m_log.begin();
  if (!observation::isScan(obs)) return m_log.ignore("it is not a scan");
  if (!observation::is3DScan(obs) && !inserts2D())
    return m_log.ignore("it is a 2D scan, and those are not inserted");
  checkOptions();
  const mrpt::system::CTicTac watch;
  const auto scan =
      observation::sensorPoints(obs, robotPose.value_or(mrpt::poses::CPose3D()), &m_log.warnings);
  if (!scan || scan->empty()) return m_log.skip(obs, "it has no usable point");
  if (const std::string why = insertScan(*scan); !why.empty()) return m_log.skip(obs, why);
  times().registerUserMeasure("insert", watch.Tac(), true);
  return true;
}

/** Whether the grid has the frame of the shown layer: MRPT's particle filter resizes it. */
bool LayerGridMap2D::isLaidOut() const
{
  const grid::GridFrame& frame = shownLayer().frame();
  return getSizeX() == static_cast<unsigned>(frame.width) &&
         getSizeY() == static_cast<unsigned>(frame.height) &&
         std::abs(getResolution() - frame.resolution) < 1e-6 * frame.resolution &&
         std::abs(getXMin() - frame.xMin()) < 0.25 * frame.resolution &&
         std::abs(getYMin() - frame.yMin()) < 0.25 * frame.resolution;
}

/** A map in which nothing is known has nothing to lay out. */
bool LayerGridMap2D::mustBeLaidOut() const { return !shownLayer().frame().empty() && !isLaidOut(); }

/** Calls use() with this grid or, if it must be laid out anew, with one that is. */
template <class Use>
void LayerGridMap2D::withRightGrid(const Use& use) const
{
  if (!mustBeLaidOut())
  {
    use(static_cast<const Base&>(*this));
    return;
  }
  Base right(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f);
  right.genericMapParams = genericMapParams;
  right.insertionOptions = insertionOptions;
  right.likelihoodOptions = likelihoodOptions;
  grid::copyToGridMap(shownLayer(), right);
  use(right);
}

void LayerGridMap2D::determineMatching2D(const mrpt::maps::CMetricMap* otherMap,
                                         const mrpt::poses::CPose2D& otherMapPose,
                                         mrpt::tfest::TMatchingPairList& correspondences,
                                         const mrpt::maps::TMatchingParams& params,
                                         mrpt::maps::TMatchingExtraResults& extraResults) const
{
  withRightGrid(
      [&](const Base& grid) {
        grid.Base::determineMatching2D(otherMap, otherMapPose, correspondences, params,
                                       extraResults);
      });
}

void LayerGridMap2D::auxParticleFilterCleanUp()
{
  if (mustBeLaidOut()) showAllCells();
}

void LayerGridMap2D::startEmpty()
{
  constexpr float cells = 10;  // MRPT's grids are never without cells
  const auto half = static_cast<float>(cells * m_cellSize);
  setSize(-half, half, -half, half, static_cast<float>(m_cellSize));
  m_is_empty = true;
}

void LayerGridMap2D::showAllCellsOf(const grid::Layer<float>& layer)
{
  m_likelihoodCacheOutDated = true;
  if (layer.frame().empty())
    startEmpty();
  else
    grid::copyToGridMap(layer, *this);
}

void LayerGridMap2D::showAllCells() { showAllCellsOf(shownLayer()); }

bool LayerGridMap2D::showCells(const voxel::ColumnSet& columns)
{
  if (!isLaidOut())
  {
    showAllCells();
    return true;
  }
  m_likelihoodCacheOutDated = true;
  const auto& layer = shownLayer();
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
  return false;
}

SelfDescription LayerGridMap2D::describe() const
{
  SelfDescription description;
  description.name = "layers";
  for (const auto& layer : styledLayers())
  {
    const std::string unit = layer.unit.empty() ? "" : " [" + layer.unit + "]";
    description.lines.emplace_back(layer.name, layer.title + unit);
    description.values.emplace_back(layer.name, layer.title + unit);
  }
  return description;
}

void LayerGridMap2D::getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const
{
  if (genericMapParams.enableSaveAs3DObject && !shownLayer().frame().empty()) drawLayers(scene);
}

void LayerGridMap2D::drawLayers(mrpt::opengl::CSetOfObjects& scene) const
{
  grid::drawLayers(styledLayers(), shownLayer(), scene);
}

void LayerGridMap2D::saveMetricMapRepresentationToFile(const std::string& prefix) const
{
  withRightGrid(
      [&](const Base& grid)
      {
        saveStaged(grid, prefix,
                   [this](files::OutputDir& out, const std::string& name)
                   {
                     if (!shownLayer().frame().empty()) saveLayers(out, name);
                     m_times.save([&] { return out.path(name + "_times.csv"); });
                   });
      });
}

void LayerGridMap2D::saveLayers(files::OutputDir& out, const std::string& name) const
{
  grid::ExportFormats formats{name + "_layers.tif"};
  formats.prefix = name + "_";
  formats.pictures = true;
  grid::exportLayers(out, styledLayers(), formats);
}

}  // namespace mrpt_mapconv::maps
