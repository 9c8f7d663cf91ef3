#include "input/ScanInserter.h"

#include <mrpt_mapconv/observation/ObservationPoints.h>

#include <algorithm>
#include <cctype>
#include <numeric>

#include "output/Console.h"
#include "output/Progress.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using observation::PosedObservation;

namespace
{
/** What a reason says whatever the scan's figures are. */
std::string withoutNumbers(std::string why)
{
  const auto isOfNumber = [](unsigned char c) { return std::isdigit(c) || c == '.' || c == '-'; };
  why.erase(std::remove_if(why.begin(), why.end(), isOfNumber), why.end());
  return why;
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

ScanInserter::ScanInserter(const ScanSettings& settings)
    : m_settings(settings), m_map(settings.grid.resolution)
{
  m_map.maxGridCells = settings.grid.maxGridCells;
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
    countSkip(m_map.lastSkip());
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

void ScanInserter::countSkip(const std::string& why)
{
  auto& skipped = m_figures.skipped[withoutNumbers(why)];
  if (skipped.count++ == 0) skipped.why = why;
}

}  // namespace mapconv
