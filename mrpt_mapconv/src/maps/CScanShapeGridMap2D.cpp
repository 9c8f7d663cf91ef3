#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/maps/ObservationPoints.h>

#include <cmath>
#include <utility>

#include "MapSections.h"

namespace mrpt_mapconv
{
using Base = mrpt::maps::COccupancyGridMap2D;

/** What an insertion works with; kept so that the next one needs no memory. */
struct CScanShapeGridMap2D::Workspace
{
  explicit Workspace(const mrpt::system::COutputLogger& log) : warnings(&log) {}

  maps::PointWarnings warnings;
  maps::SensorPoints scan;
  scan::ScanProfile profile;
  bool saidFewWalls = false;
};

namespace
{
bool isFinite(const mrpt::poses::CPose3D& pose)
{
  const auto p = pose.asTPose();
  for (const double value : {p.x, p.y, p.z, p.yaw, p.pitch, p.roll})
    if (!std::isfinite(value)) return false;
  return true;
}

mrpt::poses::CPose3D sensorPoseOf(const mrpt::obs::CObservation& obs,
                                  const mrpt::poses::CPose3D& robotPose)
{
  mrpt::poses::CPose3D sensorOnRobot;
  obs.getSensorPose(sensorOnRobot);
  return robotPose + sensorOnRobot;
}

void warnSkipped(maps::PointWarnings& warnings, const mrpt::obs::CObservation& obs,
                 const std::string& why)
{
  const auto name = maps::nameOf(obs);
  warnings.warnOnceOf("skipped: " + name, "a scan of " + name + " is skipped: " + why);
}
}  // namespace

CScanShapeGridMap2D::CScanShapeGridMap2D(double resolution)
    : Base(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f),  // its own default is large
      m_log("CScanShapeGridMap2D"),
      m_cellSize(maps::checkedResolution(resolution))
{
  startEmpty();
}

CScanShapeGridMap2D::~CScanShapeGridMap2D() = default;

CScanShapeGridMap2D::CScanShapeGridMap2D(const CScanShapeGridMap2D& o)
    : Base(o),
      scanInsertionOptions(o.scanInsertionOptions),
      maxGridCells(o.maxGridCells),
      m_log(o.m_log),
      m_cellSize(o.m_cellSize)
{
}

CScanShapeGridMap2D& CScanShapeGridMap2D::operator=(const CScanShapeGridMap2D& o)
{
  if (this == &o) return *this;
  Base::operator=(o);
  scanInsertionOptions = o.scanInsertionOptions;
  maxGridCells = o.maxGridCells;
  m_cellSize = o.m_cellSize;
  m_work.reset();
  return *this;
}

CScanShapeGridMap2D::Workspace& CScanShapeGridMap2D::workspace()
{
  if (!m_work) m_work = std::make_unique<Workspace>(m_log);
  return *m_work;
}

scan::ProfileStatistics CScanShapeGridMap2D::lastScan() const
{
  return m_work ? m_work->profile.statistics() : scan::ProfileStatistics();
}

void CScanShapeGridMap2D::internal_clear()
{
  m_cellSize = frame().resolution;
  startEmpty();
}

bool CScanShapeGridMap2D::internal_insertObservation(
    const mrpt::obs::CObservation& obs, const std::optional<const mrpt::poses::CPose3D>& robotPose)
{
  if (!maps::isScan(obs)) return false;
  const auto pose = robotPose.value_or(mrpt::poses::CPose3D());
  if (!isFinite(sensorPoseOf(obs, pose)))
  {
    warnSkipped(workspace().warnings, obs, "its pose is not finite");
    return false;
  }
  if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&obs))
    return insert2D(*scan, pose);
  return insert3D(obs, pose);
}

bool CScanShapeGridMap2D::insert3D(const mrpt::obs::CObservation& obs,
                                   const mrpt::poses::CPose3D& robotPose)
{
  if (updateInfoChangeOnly.enabled) return false;  // a likelihood asks, nothing may change
  scanInsertionOptions.check();
  const scan::LogOddsUpdate update(scanInsertionOptions.update);
  auto& work = workspace();
  if (!maps::sensorPoints(obs, robotPose, work.scan, &work.warnings)) return false;
  if (work.scan.points.empty()) return false;
  try
  {
    work.profile.compute(work.scan.points,
                         {work.scan.sensorPose, robotPose.z(), work.scan.azimuthStep},
                         frame().resolution, scanInsertionOptions.profile);
  }
  catch (const scan::UnusableScan& error)
  {
    warnSkipped(work.warnings, obs, error.what());
    return false;
  }
  report(obs);
  const grid::GridFrame bounds = work.profile.bounds();
  if (bounds.empty()) return false;
  makeRoomFor(bounds);
  update.apply(work.profile, frame(), m_map.data());
  m_likelihoodCacheOutDated = true;
  return true;
}

/** Says how many azimuths end at a structural element; where they do not, nothing is cut. */
void CScanShapeGridMap2D::report(const mrpt::obs::CObservation& obs)
{
  const auto& params = scanInsertionOptions.profile;
  const auto& found = m_work->profile.statistics();
  if (m_log.isLoggingLevelVisible(mrpt::system::LVL_DEBUG))
    m_log.logFmt(mrpt::system::LVL_DEBUG,
                 "%s: %zu points, %zu of objects, %zu of structure; a wall on %.1f %% of %i "
                 "azimuths; %zu cells occupied, %zu free",
                 maps::nameOf(obs).c_str(), found.points, found.objectPoints, found.structurePoints,
                 100 * found.shareWithWall(), found.lines, found.occupiedCells, found.freeCells);
  constexpr double fewest = 0.1;
  if (!params.reflectionFilter || m_work->saidFewWalls || found.shareWithWall() >= fewest) return;
  m_work->saidFewWalls = true;
  m_work->warnings.warn(
      mrpt::format("only %.1f %% of a scan's azimuths have a wall between structureMinZ = %g m and "
                   "structureMaxZ = %g m: reflections are not cut along the others (said once)",
                   100 * found.shareWithWall(), params.structureMinZ, params.structureMaxZ));
}

std::string CScanShapeGridMap2D::asString() const
{
  return "Scan-shape grid map: " + Base::asString();
}

void CScanShapeGridMap2D::getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const
{
  if (!isAsStarted()) Base::getVisualizationInto(scene);
}

}  // namespace mrpt_mapconv
