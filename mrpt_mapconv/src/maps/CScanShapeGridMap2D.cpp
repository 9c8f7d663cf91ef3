#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/maps/MapDefinition.h>
#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/PoseTrack.h>
#include <mrpt_mapconv/scan/ProfileSummary.h>

namespace mrpt_mapconv
{
using Base = mrpt::maps::COccupancyGridMap2D;

/** What an insertion works with; kept so that the next one needs no memory. */
struct CScanShapeGridMap2D::Workspace
{
  observation::SensorPoints scan;
  scan::ScanProfile profile;
};

namespace
{
mrpt::poses::CPose3D sensorPoseOf(const mrpt::obs::CObservation& obs,
                                  const mrpt::poses::CPose3D& robotPose)
{
  mrpt::poses::CPose3D sensorOnRobot;
  obs.getSensorPose(sensorOnRobot);
  return robotPose + sensorOnRobot;
}

/** Why nothing of a scan is left. */
const char* whyEmpty(const scan::ProfileStatistics& found)
{
  return found.objectPoints > 0
             ? "all of its objects are behind walls"
             : "it has no object between objectMinZ and objectMaxZ, minRange and maxRange";
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
  m_log = o.m_log;
  m_cellSize = o.m_cellSize;
  m_lastScan = {};
  return *this;
}

CScanShapeGridMap2D::Workspace& CScanShapeGridMap2D::workspace()
{
  if (!m_work) m_work = std::make_unique<Workspace>();
  return *m_work;
}

void CScanShapeGridMap2D::internal_clear()
{
  m_cellSize = frame().resolution;
  startEmpty();
}

bool CScanShapeGridMap2D::internal_insertObservation(
    const mrpt::obs::CObservation& obs, const std::optional<const mrpt::poses::CPose3D>& robotPose)
{
  // a likelihood asks: nothing may change, and MRPT's own grid counts nothing either
  if (updateInfoChangeOnly.enabled) return false;
  const auto pose = robotPose.value_or(mrpt::poses::CPose3D());
  m_log.begin();
  if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&obs))
    return insert2D(*scan, pose);
  if (observation::isScan(obs)) return insert3D(obs, pose);
  return m_log.ignore("it is not a scan");
}

bool CScanShapeGridMap2D::insert3D(const mrpt::obs::CObservation& obs,
                                   const mrpt::poses::CPose3D& robotPose)
{
  scanInsertionOptions.check();
  const scan::LogOddsUpdate update(scanInsertionOptions.update);
  const auto sensorPose = sensorPoseOf(obs, robotPose);
  if (!observation::isFinite(sensorPose)) return m_log.skip(obs, "its pose is not finite");
  checkNear(sensorPose);
  auto& work = workspace();
  observation::sensorPoints(obs, robotPose, work.scan, &m_log.warnings);
  if (work.scan.points.empty())
    return m_log.skip(
        obs, work.scan.empty() ? "it has no usable point" : "all of its returns are at maxRange");
  warnOfOverlap();
  try
  {
    work.profile.compute(work.scan.points,
                         {work.scan.sensorPose, robotPose.z(), work.scan.azimuthStep},
                         frame().resolution, scanInsertionOptions.profile);
  }
  catch (const scan::UnusableScan& error)
  {
    return m_log.skip(obs, "unusable", error.what());
  }
  if (const auto ceiling = work.profile.statistics().ceiling)
    return m_log.skip(obs, kCeilingSkip, scan::ceilingText(*ceiling, scanInsertionOptions.profile));
  const grid::GridFrame bounds = work.profile.bounds();
  if (!bounds.empty())
  {
    makeRoomFor(bounds);
    update.apply(work.profile, frame(), m_map.data());
    m_likelihoodCacheOutDated = true;
  }
  m_lastScan = work.profile.statistics();
  report(obs);
  return !bounds.empty() || m_log.skip(obs, whyEmpty(m_lastScan));
}

/** Says so if furniture can pass for walls. */
void CScanShapeGridMap2D::warnOfOverlap()
{
  const auto& params = scanInsertionOptions.profile;
  if (params.reflectionFilter && params.slicesOverlap())
    m_log.warnings.warnOnceOf({"slices overlap"}, [&] { return scan::overlapText(params); });
}

/** Whether the first 3D scan has been reported; from now on it has. */
bool CScanShapeGridMap2D::hasReported() { return !m_log.warnings.isNew({"first 3D scan"}); }

/** Says how many azimuths end at a structural element; where they do not, nothing is cut. */
void CScanShapeGridMap2D::report(const mrpt::obs::CObservation& obs)
{
  using mrpt::system::LVL_DEBUG, mrpt::system::LVL_INFO;
  const auto& params = scanInsertionOptions.profile;
  const auto& found = m_lastScan;
  const double percent = 100 * found.shareWithWall();
  if (m_log.logger.isLoggingLevelVisible(LVL_DEBUG))
    m_log.logger.logFmt(LVL_DEBUG,
                        "%s: %zu points, %zu of objects, %zu of structure; a wall on %.1f %% of %i "
                        "azimuths; %zu cells occupied, %zu free",
                        observation::nameOf(obs).c_str(), found.points, found.objectPoints,
                        found.structurePoints, percent, found.lines, found.occupiedCells,
                        found.freeCells);
  if (!params.reflectionFilter) return;
  if (!hasReported())
    m_log.logger.logFmt(LVL_INFO, "first 3D scan, of %s: a wall on %.1f %% of %i azimuths",
                        observation::nameOf(obs).c_str(), percent, found.lines);
  constexpr double fewest = 10;
  if (percent >= fewest) return;
  m_log.warnings.warnOnceOf(
      {"few walls"},
      [&]
      {
        return mrpt::format(
            "only %.1f %% of a scan's azimuths have a wall between structureMinZ = %g m and "
            "structureMaxZ = %g m: reflections are not cut along the others",
            percent, params.structureMinZ, params.structureMaxZ);
      });
}

std::string CScanShapeGridMap2D::asString() const
{
  return "Scan-shape grid map: " + Base::asString();
}

maps::SelfDescription CScanShapeGridMap2D::describe() const
{
  const auto& profile = scanInsertionOptions.profile;
  maps::SelfDescription description{{{"model", scan::summaryOf(profile)}}, "parameters", {}};
  params::visitFields(profile, [&](const char* name, const auto& field, auto&&...)
                      { description.values.emplace_back(name, params::shownValue(field)); });
  return description;
}

void CScanShapeGridMap2D::getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const
{
  if (!isAsStarted()) Base::getVisualizationInto(scene);
}

}  // namespace mrpt_mapconv
