#include "input/TerrainBuilder.h"

#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/terrain/ScanInsertion.h>

#include <numeric>

namespace mapconv
{
using namespace mrpt_mapconv;
using observation::PosedObservation;

std::size_t TerrainFigures::skips() const
{
  return std::accumulate(skipped.begin(), skipped.end(), std::size_t(0),
                         [](std::size_t sum, const auto& reason) { return sum + reason.second; });
}

TerrainBuilder::TerrainBuilder(const TerrainSettings& settings)
    : m_settings(settings),
      m_map(settings.grid.resolution, settings.terrain.params),
      m_warnings(&m_log)
{
}

void TerrainBuilder::insert(const PosedObservation& scan)
{
  if (!observation::is3DScan(*scan.observation))
  {
    ++m_figures.scans2D;
    return;
  }
  m_points.clear();
  observation::sensorPoints(*scan.observation, scan.robotPose, m_points, &m_warnings);
  insert(m_points, scan.poseCovariance);
}

void TerrainBuilder::insert(const observation::CloudScan& scan)
{
  insert(scan.points, scan.poseCovariance);
}

void TerrainBuilder::insert(const observation::SensorPoints& points,
                            const std::optional<observation::HeightCovariance>& poseCovariance)
{
  if (points.points.empty()) return skip("no usable point");
  if (!observation::isFinite(points.sensorPose)) return skip("its pose is not finite");
  const auto& options = m_settings.insertion;
  const auto used = terrain::usedPoints(points, options.limits);
  m_figures.beyondLimits += used.leftOut;
  if (used.points.empty()) return skip("no point within maxRange, minHeight and maxHeight");
  auto frame = terrain::frameOf(used, m_map);
  if (m_map.params().localWindow <= 0) frame = unite(m_map.frame(), frame);
  m_settings.grid.checkSize(frame);

  const auto covariance = poseCovariance.value_or(options.sigmas.poseCovariance());
  const auto inserted = terrain::insertScan(m_map, points, used, options.sigmas, covariance);
  ++m_figures.scans;
  m_figures.withCovariance += poseCovariance.has_value();
  m_figures.points += inserted.inserted;
  m_figures.outsideWindow += inserted.outside;
}

}  // namespace mapconv
