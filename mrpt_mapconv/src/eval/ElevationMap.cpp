#include <mrpt_mapconv/eval/ElevationMap.h>
#include <mrpt_mapconv/grid/GrownFrame.h>
#include <mrpt_mapconv/grid/Resolution.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "../grid/Wide.h"
#include "ElevationFusion.h"
#include "ElevationUpdate.h"

namespace mrpt_mapconv::eval
{
using grid::GridFrame;
using grid::Layer;
using terrain::PointModel;

namespace
{
constexpr double kMostCells = 4e8;
constexpr double kMargin = 0.25;  // of the grid's side, where it has to grow
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/** The keys of a batch's cells; nothing if xMin is above xMax. */
struct KeyBox
{
  std::int32_t xMin = std::numeric_limits<std::int32_t>::max();
  std::int32_t yMin = std::numeric_limits<std::int32_t>::max();
  std::int32_t xMax = std::numeric_limits<std::int32_t>::min();
  std::int32_t yMax = std::numeric_limits<std::int32_t>::min();
};

MRPT_MAPCONV_WIDE
KeyBox boxOf(const PointModel::Batch& points, std::size_t count)
{
  // variables of their own fit into registers
  const KeyBox none;
  std::int32_t xMin = none.xMin, yMin = none.yMin, xMax = none.xMax, yMax = none.yMax;
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isPoint = points.weight[i] != 0;
    const std::int32_t kx = points.kx[i], ky = points.ky[i];
    xMin = std::min(xMin, isPoint ? kx : none.xMin);
    yMin = std::min(yMin, isPoint ? ky : none.yMin);
    xMax = std::max(xMax, isPoint ? kx : none.xMax);
    yMax = std::max(yMax, isPoint ? ky : none.yMax);
  }
  return {xMin, yMin, xMax, yMax};
}

/** The frame of a batch's cells, like another one. */
GridFrame frameOf(const PointModel::Batch& points, std::size_t count, GridFrame like)
{
  const KeyBox box = boxOf(points, count);
  like.x0 = box.xMin;
  like.y0 = box.yMin;
  like.width = box.xMin > box.xMax ? 0 : box.xMax - box.xMin + 1;
  like.height = box.xMin > box.xMax ? 0 : box.yMax - box.yMin + 1;
  return like;
}

[[noreturn]] void failForSize(const GridFrame& frame)
{
  throw std::runtime_error(
      "elevation map: " + std::to_string(frame.width) + " x " + std::to_string(frame.height) +
      " cells of " + std::to_string(frame.resolution) +
      " m are more than 4e8: a coarser resolution or nearer points are needed");
}
}  // namespace

void ElevationMapParams::check() const
{
  const auto isFinite = [](double variance) { return variance >= 0 && std::isfinite(variance); };
  params::require(isFinite(minVariance), "minVariance", minVariance, "a finite variance >= 0 m^2");
  params::require(maxVariance >= minVariance, "maxVariance", maxVariance,
                  "a variance >= minVariance [m^2]");
  params::require(mahalanobisDistanceThreshold > 0, "mahalanobisDistanceThreshold",
                  mahalanobisDistanceThreshold, "a number > 0");
  params::require(isFinite(multiHeightNoise), "multiHeightNoise", multiHeightNoise,
                  "a finite variance >= 0 m^2");
}

ElevationMap::ElevationMap(double resolution, const ElevationMapParams& params) : m_params(params)
{
  params.check();
  grid::requireResolution(resolution);
  m_known.resolution = resolution;
  m_known.shift = -0.5;
  m_cells = Layer<Cell>(m_known, Cell());
}

terrain::InsertedPoints ElevationMap::insert(const terrain::TerrainScan& scan,
                                             const terrain::PointSigmas& sigmas)
{
  const PointModel model(scan, sigmas, resolution());
  model.checkRange();
  const UpdateRule rule(m_params, ++m_scan);
  terrain::InsertedPoints told;
  PointModel::Batch points;
  for (std::size_t first = 0; first < scan.points; first += PointModel::kBatch)
  {
    const std::size_t count = std::min(PointModel::kBatch, scan.points - first);
    model.compute(first, count, points);
    makeRoomFor(frameOf(points, count, m_known));
    told.inserted += updateCells(points, count, rule, m_cells);
  }
  told.notFinite = scan.points - told.inserted;
  return told;
}

void ElevationMap::makeRoomFor(const GridFrame& needed)
{
  if (needed.empty()) return;
  const GridFrame frame = m_cells.frame();
  if (unite(frame, needed) != frame)
  {
    const auto isAllowed = [](const GridFrame& f)
    { return static_cast<double>(f.width) * f.height <= kMostCells; };
    const GridFrame grown = grid::grownFrame(frame, needed, {kMargin}, isAllowed);
    if (!isAllowed(grown)) failForSize(grown);
    m_cells = m_cells.onFrame(grown, Cell());
  }
  m_known = unite(m_known, needed);
}

const FusedElevation& ElevationMap::fuse()
{
  if (m_fused.height.frame() != m_known)
    for (Layer<float>* layer : {&m_fused.height, &m_fused.lower, &m_fused.upper})
      *layer = Layer<float>(m_known, kNaN);
  fuseElevation(m_cells, VarianceLimits(m_params), m_fused);
  return m_fused;
}

/** Values of the cells that are known. \param valueOf of height and variance */
template <class ValueOf>
Layer<float> ElevationMap::layerOf(const ValueOf& valueOf) const
{
  const VarianceLimits limits(m_params);
  Layer<float> layer(m_known, kNaN);
  const Layer<Cell> cells = m_cells.onFrame(m_known, Cell());
  for (std::size_t i = 0; i < layer.cells().size(); ++i)
  {
    const float variance = limits(cells.cells()[i].variance);
    if (std::isfinite(variance)) layer.cells()[i] = valueOf(cells.cells()[i].height, variance);
  }
  return layer;
}

Layer<float> ElevationMap::height() const
{
  return layerOf([](float height, float) { return height; });
}

Layer<float> ElevationMap::variance() const
{
  return layerOf([](float, float variance) { return variance; });
}

std::size_t ElevationMap::memory() const
{
  return m_cells.cells().capacity() * sizeof(Cell) +
         3 * m_fused.height.cells().capacity() * sizeof(float);
}

}  // namespace mrpt_mapconv::eval
