#include "experiment/scan_shape/ScanShapeRun.h"

#include <mrpt/core/format.h>
#include <mrpt_mapconv/eval/ScanShapeMaps.h>
#include <mrpt_mapconv/sim/Simulator.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "experiment/report/Table.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
scan::ProfileParams uncut(scan::ProfileParams params)
{
  params.reflectionFilter = false;
  return params;
}

scan::ProfileParams closestPoint(const scan::ProfileParams& params)
{
  scan::ProfileParams closest = uncut(params);
  closest.model = scan::Model::ClosestPoint;
  return closest;
}

/** Complains about an estimate that leads a sensor to where it cannot be. */
[[noreturn]] void failPose(const std::string& world, double seconds, const std::string& what)
{
  throw std::runtime_error(mrpt::format(
      "%s: section 'noise': posePosition or poseAngle must be smaller, as the pose estimate at "
      "%.2f s is of no use: %s",
      world.c_str(), seconds, what.c_str()));
}

/** What a 3D sensor has seen, as the maps get it. \param[out] scan its memory is kept */
void takeScan(const sim::Scan& seen, const mrpt::poses::CPose3D& robotPose, eval::PosedScan& scan)
{
  if (!observation::sensorPoints(*seen.observation, robotPose, scan.points))
    throw std::logic_error("a simulated scan has no points");
  if (scan.points.points.size() != seen.bodies.size())
    throw std::logic_error("a scan has points that the simulator does not know");
  scan.view = {scan.points.sensorPose, robotPose.z(), scan.points.azimuthStep};
}

/** The points of a scan that are where they seem to be. */
std::vector<mrpt::math::TPoint3Df> realPoints(const sim::Scan& seen, const eval::PosedScan& scan)
{
  std::vector<mrpt::math::TPoint3Df> real;
  for (std::size_t i = 0; i < scan.points.points.size(); ++i)
    if (!seen.mirrored[i]) real.push_back(scan.points.points[i]);
  return real;
}

/** Room for all that is updated by scans that are taken within the world's bounds. */
grid::GridFrame frameAround(const sim::World& world, const ScanShapeSettings& settings)
{
  grid::GridFrame frame = sim::frameOf(world, settings.resolution);
  const double range =
      std::max<double>(settings.profile.maxRange, settings.scanner.maxDistanceInsertion);
  const auto reach = static_cast<std::int32_t>(std::ceil(range / settings.resolution)) + 1;
  frame.x0 -= reach;
  frame.y0 -= reach;
  frame.width += 2 * reach;
  frame.height += 2 * reach;
  return frame;
}

/** The settings' increments, then those of the sweep. */
std::vector<scan::UpdateParams> updatesOf(const ScanShapeSettings& settings, bool withSweep)
{
  std::vector<scan::UpdateParams> updates = {settings.update};
  if (!withSweep) return updates;
  for (const double pMiss : settings.sweep.pMiss)
    for (const double pHit : settings.sweep.pHit)
    {
      updates.push_back(settings.update);
      updates.back().pHit = pHit;
      updates.back().pMiss = pMiss;
    }
  return updates;
}

/** A map with another value of one of the profile's parameters. */
struct TriedProfile
{
  std::string parameter, value;
  eval::ProfileGrids grids;
};

std::vector<TriedProfile> profilesOf(const grid::GridFrame& frame,
                                     const ScanShapeSettings& settings)
{
  std::vector<TriedProfile> tried;
  const auto add = [&](const std::string& parameter, const std::string& value, const auto& params) {
    tried.push_back({parameter, value, eval::ProfileGrids(frame, params, {settings.update})});
  };
  for (const double tolerance : settings.sweep.structureTolerance)
  {
    scan::ProfileParams params = settings.profile;
    params.structureTolerance = tolerance;
    add("structureTolerance [m]", fixed(tolerance, 2), params);
  }
  for (const std::int32_t sectors : settings.sweep.sectors)
  {
    scan::ProfileParams params = settings.profile;
    params.sectors = sectors;
    add("sectors", std::to_string(sectors), params);
  }
  return tried;
}

/** All maps of a drive. */
class Drive
{
 public:
  Drive(const sim::Scenario& scenario, const ScanShapeSettings& settings, std::uint32_t seed,
        bool withSweep)
      : m_settings(settings),
        m_world(scenario.world),
        m_frame(frameAround(scenario.world, settings)),
        m_updates(updatesOf(settings, withSweep)),
        m_scanner(m_frame, settings.scanner),
        m_closest(m_frame, closestPoint(settings.profile), {settings.update}),
        m_counts(m_frame),
        m_uncut(m_frame, uncut(settings.profile), {settings.update}),
        m_cut(m_frame, settings.profile, m_updates),
        m_history(m_frame, scenario.world, settings.profile)
  {
    m_run.seed = seed;
    for (const double margin : settings.margins)
      m_outside.emplace_back(m_frame, settings.regions, margin, settings.update);
    if (withSweep) m_tried = profilesOf(m_frame, settings);
  }

  void insert(const sim::Moment& moment)
  {
    for (const sim::Scan& scan : moment.scans)
    {
      checkPlace(scan, moment);
      if (scan.is3D)
        insert3D(scan, moment);
      else
        insert2D(scan, moment.estimatedPose);
    }
  }

  /** Whether the settings ask for no more scans. */
  bool isOver() const
  {
    return m_settings.maxScans > 0 &&
           m_run.scans3D >= static_cast<std::size_t>(m_settings.maxScans);
  }

  ScanShapeRun judged(const eval::ScanShapeTruth& truth)
  {
    takeMaps();
    for (std::size_t i = 0; i < kScanMethods; ++i)
      m_run.scores[i] = eval::scoreOf(m_run.maps[i], truth);
    judgeCut(truth);
    judgeTrials(truth);
    m_run.shareWithWall /= static_cast<double>(m_run.scans3D);
    return std::move(m_run);
  }

 private:
  grid::Layer<float>& map(ScanMethod method)
  {
    return m_run.maps[static_cast<std::size_t>(method)];
  }

  /** All cells that are within range of a sensor in the world have their place in the frame. */
  void checkPlace(const sim::Scan& scan, const sim::Moment& moment) const
  {
    const auto sensor = moment.estimatedPose + mrpt::poses::CPose3D(scan.observation->sensorPose());
    const sim::Footprint bounds{m_world.min().x, m_world.min().y, m_world.max().x, m_world.max().y};
    if (!eval::holds(bounds, sensor.x(), sensor.y()))
      failPose(m_settings.world, moment.seconds,
               mrpt::format("it places a sensor at (%.2f, %.2f) m, outside the world's bounds",
                            sensor.x(), sensor.y()));
  }

  void insert2D(const sim::Scan& scan, const mrpt::poses::CPose3D& robotPose)
  {
    ++m_run.scans2D;
    if (!m_scanner.insert(*scan.observation, robotPose)) ++m_run.refused2D;
  }

  void insert3D(const sim::Scan& seen, const sim::Moment& moment)
  {
    takeScan(seen, moment.estimatedPose, m_scan);
    try
    {
      updateMaps(seen);
    }
    catch (const scan::UnusableScan& error)
    {
      failPose(m_settings.world, moment.seconds, error.what());
    }
    ++m_run.scans3D;
    m_run.points += m_scan.points.points.size();
    m_run.shareWithWall += m_cut.profile().statistics().shareWithWall();
  }

  void updateMaps(const sim::Scan& seen)
  {
    m_closest.insert(m_scan);
    m_uncut.insert(m_scan);
    m_counts.add(m_uncut.profile());
    m_cut.insert(m_scan);
    m_real.compute(realPoints(seen, m_scan), m_scan.view, m_frame.resolution,
                   uncut(m_settings.profile));
    for (eval::OutsideMaps& outside : m_outside)
      outside.add(m_scan.view, {m_real, m_uncut.profile(), m_cut.profile()});
    for (TriedProfile& tried : m_tried) tried.grids.insert(m_scan);
    m_history.add(seen, m_scan, m_cut.profile());
  }

  void takeMaps()
  {
    map(ScanMethod::Scanner2D) = m_scanner.labels();
    map(ScanMethod::ClosestPoint) = m_closest.labels();
    map(ScanMethod::Counts) = m_counts.labels();
    map(ScanMethod::WholeShape) = m_uncut.labels();
    map(ScanMethod::WholeShapeCut) = m_cut.labels();
  }

  void judgeCut(const eval::ScanShapeTruth& truth)
  {
    const auto& uncutMap = map(ScanMethod::WholeShape);
    const auto& cutMap = map(ScanMethod::WholeShapeCut);
    for (std::size_t i = 0; i < truth.regions.size(); ++i)
    {
      m_run.uncutRegions.push_back(eval::scoreRegion(uncutMap, truth, i));
      m_run.cutRegions.push_back(eval::scoreRegion(cutMap, truth, i));
    }
    for (const eval::OutsideMaps& outside : m_outside)
      m_run.outside.push_back(outside.judged(truth));
    m_run.uncutFalse = eval::falseObstacles(uncutMap, truth, m_history.cells());
    m_run.cutFalse = eval::falseObstacles(cutMap, truth, m_history.cells());
    m_run.people = eval::peopleTraces(cutMap, truth, m_history.cells());
  }

  void judgeTrials(const eval::ScanShapeTruth& truth)
  {
    for (std::size_t i = 1; i < m_updates.size(); ++i)
    {
      const auto labels = m_cut.labels(i);
      m_run.updateTrials.push_back({m_updates[i], eval::scoreOf(labels, truth),
                                    eval::peopleTraces(labels, truth, m_history.cells())});
    }
    for (const TriedProfile& tried : m_tried)
      m_run.profileTrials.push_back(
          {tried.parameter, tried.value, eval::scoreOf(tried.grids.labels(), truth)});
  }

  const ScanShapeSettings& m_settings;
  const sim::World& m_world;
  grid::GridFrame m_frame;
  std::vector<scan::UpdateParams> m_updates;
  eval::ScannerGrid m_scanner;
  eval::ProfileGrids m_closest;
  eval::CountGrid m_counts;
  eval::ProfileGrids m_uncut, m_cut;
  std::vector<TriedProfile> m_tried;
  scan::ScanProfile m_real;                  //!< of the returns that were not reflected
  std::vector<eval::OutsideMaps> m_outside;  //!< one for each margin
  eval::DriveHistory m_history;
  eval::PosedScan m_scan;  //!< kept, for its memory
  ScanShapeRun m_run;
};
}  // namespace

ScanShapeRun driveThrough(const sim::Scenario& scenario, const eval::ScanShapeTruth& truth,
                          const ScanShapeSettings& settings, std::uint32_t seed, bool withSweep,
                          Progress& progress)
{
  Drive drive(scenario, settings, seed, withSweep);
  sim::Simulator simulator(scenario, seed);
  while (const auto moment = simulator.next())
  {
    progress.done(moment->seconds / scenario.trajectory.duration());
    drive.insert(*moment);
    if (drive.isOver()) break;
  }
  return drive.judged(truth);
}

}  // namespace mapconv
