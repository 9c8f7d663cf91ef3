#include "ScanInserter.h"

#include <mrpt_mapconv/maps/ObservationPoints.h>

#include <numeric>
#include <utility>

#include "Console.h"
#include "Progress.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using maps::PosedObservation;

namespace
{
std::pair<Skip, std::string> skipOf2D(bool wanted)
{
  if (wanted) return {Skip::Refused2D, "a 2D scan that is empty or not level"};
  return {Skip::NotWanted2D, "a 2D scan, and insert2D = false"};
}

/** Asks again what the map, which only says that it took nothing, has asked. */
std::pair<Skip, std::string> skipOf(const PosedObservation& scan, const CScanShapeGridMap2D& map)
{
  const auto& options = map.scanInsertionOptions;
  if (!maps::is3DScan(*scan.observation)) return skipOf2D(options.insert2D);
  const auto seen = maps::sensorPoints(*scan.observation, scan.robotPose);
  if (!seen || seen->points.empty()) return {Skip::NoPoints, "no usable point"};
  try
  {
    scan::ScanProfile().compute(seen->points,
                                {seen->sensorPose, scan.robotPose.z(), seen->azimuthStep},
                                map.frame().resolution, options.profile);
  }
  catch (const scan::UnusableScan& error)
  {
    return {Skip::Unusable, error.what()};
  }
  return {Skip::NothingValid, "no object between objectMinZ and objectMaxZ in range"};
}

double perSecond(std::size_t count, double seconds)
{
  return seconds > 0 ? static_cast<double>(count) / seconds : 0;
}
}  // namespace

std::size_t InsertionFigures::skips() const
{
  return std::accumulate(skipped.begin(), skipped.end(), std::size_t(0),
                         [](std::size_t sum, const auto& kind) { return sum + kind.second.count; });
}

double InsertionFigures::scansPerSecond() const { return perSecond(scans3D, seconds3D); }
double InsertionFigures::pointsPerSecond() const { return perSecond(points, seconds3D); }

double InsertionFigures::meanWallShare() const
{
  return scans3D > 0 ? wallShares / static_cast<double>(scans3D) : 0;
}

ScanInserter::ScanInserter(const ScanSettings& settings) : m_map(settings.resolution)
{
  m_map.maxGridCells = settings.maxGridCells;
  m_map.scanInsertionOptions = settings.insertion;
  m_map.insertionOptions = settings.insertion2D;
  takeWarningsOf(m_map.log());
}

void ScanInserter::insert(const PosedObservation& scan)
{
  Stopwatch watch;
  const bool inserted = m_map.insertObservation(*scan.observation, scan.robotPose);
  const double seconds = watch.lap();
  if (inserted)
    count(*scan.observation, seconds);
  else
    countSkip(scan);
}

void ScanInserter::count(const mrpt::obs::CObservation& obs, double seconds)
{
  if (!maps::is3DScan(obs))
  {
    ++m_figures.scans2D;
    return;
  }
  ++m_figures.scans3D;
  m_figures.points += m_map.lastScan().points;
  m_figures.seconds3D += seconds;
  m_figures.wallShares += m_map.lastScan().shareWithWall();
}

void ScanInserter::countSkip(const PosedObservation& scan)
{
  auto [kind, why] = skipOf(scan, m_map);
  auto& skipped = m_figures.skipped[kind];
  if (skipped.count++ == 0) skipped.why = std::move(why);
}

}  // namespace mapconv
