#include "input/ScanInserter.h"

#include <mrpt_mapconv/observation/ObservationPoints.h>

#include <numeric>

#include "output/Console.h"
#include "output/Progress.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using observation::PosedObservation;

namespace
{
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

std::size_t InsertionFigures::unwantedSkips() const
{
  const auto leftOut = skipped.find("");
  return skips() - (leftOut == skipped.end() ? 0 : leftOut->second.count);
}

double InsertionFigures::scansPerSecond() const { return perSecond(scans3D, seconds3D); }
double InsertionFigures::pointsPerSecond() const { return perSecond(points, seconds3D); }

double InsertionFigures::meanWallShare() const
{
  return scans3D > 0 ? wallShares / static_cast<double>(scans3D) : 0;
}

ScanInserter::ScanInserter(const ScanSettings& settings)
    : m_settings(settings), m_map(settings.grid.resolution)
{
  m_map.maxGridCells = settings.grid.maxGridCells;
  m_map.scanInsertionOptions = settings.insertion;
  m_map.insertionOptions = settings.insertion2D;
  takeWarningsOf(m_map.log(), [this] { return m_map.lastSkip().empty(); });
}

void ScanInserter::insert(const PosedObservation& scan)
{
  Stopwatch watch;
  const bool inserted = m_map.insertObservation(*scan.observation, scan.robotPose);
  const double seconds = watch.lap();
  if (inserted)
    count(*scan.observation, seconds);
  else
    countSkip();
}

void ScanInserter::count(const mrpt::obs::CObservation& obs, double seconds)
{
  if (!observation::is3DScan(obs))
  {
    ++m_figures.scans2D;
    return;
  }
  ++m_figures.scans3D;
  m_figures.points += m_map.lastScan().points;
  m_figures.seconds3D += seconds;
  m_figures.wallShares += m_map.lastScan().shareWithWall();
}

void ScanInserter::countSkip()
{
  auto& skipped = m_figures.skipped[m_map.lastSkipKind()];
  if (skipped.count++ == 0) skipped.why = m_map.lastSkip();
}

}  // namespace mapconv
