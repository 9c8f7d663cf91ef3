#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt_mapconv/observation/ExternalFiles.h>
#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/PoseTrack.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <stdexcept>

#include "LeftOut.h"
#include "PoseSources.h"

namespace mrpt_mapconv::observation
{
using mrpt::obs::CActionCollection;
using mrpt::obs::CObservation;
using mrpt::obs::CSensoryFrame;
using mrpt::poses::CPose3D;
using mrpt::serialization::CSerializable;
using mrpt::system::COutputLogger;

namespace
{
void warn(const COutputLogger* log, const std::string& text)
{
  if (log) log->logStr(mrpt::system::LVL_WARN, text);
}

std::string className(const CSerializable& object) { return object.GetRuntimeClass()->className; }

/** The parts of a rawlog that matter here. */
class Log
{
 public:
  explicit Log(const COutputLogger* log) : m_log(log) {}

  /** Takes an entry of the log; other objects are passed over but for their name. */
  void add(const CSerializable::Ptr& entry)
  {
    if (const auto actions = std::dynamic_pointer_cast<CActionCollection>(entry))
      m_poses.add(*actions);
    else if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(entry))
      for (const auto& obs : *frame) add(obs);
    else if (const auto obs = std::dynamic_pointer_cast<CObservation>(entry))
      add(obs);
    else if (const auto whole = std::dynamic_pointer_cast<mrpt::obs::CRawlog>(entry))
      for (std::size_t i = 0; i < whole->size(); ++i) add(whole->getAsGeneric(i));
    else
      m_foreign = className(*entry);
  }

  std::size_t scans() const { return m_scans.size(); }
  std::size_t scans3D() const
  {
    const auto is3D = [](const PosedObservation& s) { return is3DScan(*s.observation); };
    return static_cast<std::size_t>(std::count_if(m_scans.begin(), m_scans.end(), is3D));
  }
  /** Whether no scan, or no 3D scan, says when it was taken. */
  bool lacksTimes(bool only3D) const
  {
    const auto isTimed = [only3D](const PosedObservation& scan)
    {
      return scan.observation->timestamp != INVALID_TIMESTAMP &&
             (!only3D || is3DScan(*scan.observation));
    };
    return std::none_of(m_scans.begin(), m_scans.end(), isTimed);
  }
  const PoseSources& poses() const { return m_poses; }

  std::vector<PosedObservation> atIdentity() const
  {
    auto scans = m_scans;
    for (auto& scan : scans) scan.robotPose = CPose3D();
    return scans;
  }
  std::vector<PosedObservation> only3DAtIdentity() const
  {
    std::vector<PosedObservation> scans;
    for (const auto& scan : m_scans)
      if (is3DScan(*scan.observation)) scans.push_back({scan.observation, CPose3D()});
    if (const auto lost = m_scans.size() - scans.size(); lost > 0)
      warn(m_log, params::counted(lost, "2D scan") + (lost == 1 ? " is" : " are") +
                      " left out: the log has no poses for them");
    return scans;
  }

  /** The scans whose pose is known. \param lost gets those whose pose is not */
  std::vector<PosedObservation> posed(const RawlogOptions& options, LeftOut& lost) const
  {
    const PoseTrack* track = m_poses.choose(options.poseSource, m_log);
    if (!track) return m_scans;
    std::vector<PosedObservation> out;
    for (const auto& scan : m_scans)
      if (const auto pose = track->at(scan.observation->timestamp, options.maxPoseGap))
        out.push_back({scan.observation, *pose,
                       track->covarianceAt(scan.observation->timestamp, options.maxPoseGap)});
      else
        lost.add(*track, scan.observation->timestamp);
    return out;
  }

  void warnOf(const LeftOut& lost) const
  {
    if (lost.count() > 0)
      warn(m_log, std::to_string(lost.count()) + " of " + params::counted(m_scans.size(), "scan") +
                      (lost.count() == 1 ? " is" : " are") + " left out: " + lost.reasons() +
                      lost.remedy());
  }
  void warnOfFaultyPoses() const
  {
    if (const auto faults = m_poses.faults(); !faults.empty())
      warn(m_log, "poses are left out: " + faults);
  }

  /** Class of the last object that is no entry of a rawlog; empty if there was none. */
  const std::string& foreign() const { return m_foreign; }

 private:
  void add(const CObservation::Ptr& obs)
  {
    if (obs && !m_poses.add(*obs) && isScan(*obs)) m_scans.push_back({obs, m_poses.summedUp()});
  }

  const COutputLogger* m_log;
  std::vector<PosedObservation> m_scans;  //!< at the poses that the actions give
  PoseSources m_poses;
  std::string m_foreign;
};

/** Errors name the file. */
std::vector<PosedObservation> posedScans(const Log& log, const RawlogOptions& options,
                                         const std::string& path, LeftOut& lost)
try
{
  return log.posed(options, lost);
}
catch (const std::runtime_error& error)
{
  throw std::runtime_error(path + ": " + error.what());
}

void requireScans(const Log& log, const std::string& path)
{
  if (log.scans() > 0) return;
  if (!log.foreign().empty()) throw std::runtime_error(path + ": no scans, but a " + log.foreign());
  throw std::runtime_error(path +
                           ": no scans (CObservation3DRangeScan, CObservationPointCloud, "
                           "CObservationVelodyneScan, CObservationRotatingScan or "
                           "CObservation2DRangeScan) in this rawlog");
}

/** Reads all entries. Scans stay, the rest of a log, above all its images, is let go at once. */
Log readLog(files::ObjectFile& file, const COutputLogger* logger)
{
  Log log(logger);
  while (const auto entry = file.next()) log.add(entry);
  return log;
}

}  // namespace

bool has3DScan(const std::vector<PosedObservation>& scans)
{
  return std::any_of(scans.begin(), scans.end(),
                     [](const PosedObservation& s) { return is3DScan(*s.observation); });
}

std::vector<PosedObservation> readSimpleMap(const std::string& path, const COutputLogger* log)
{
  files::ObjectFile file(path);
  return readSimpleMap(file, log);
}

std::vector<PosedObservation> readSimpleMap(files::ObjectFile& file, const COutputLogger* log)
{
  const std::string& path = file.path();
  const auto object = file.next();
  const auto map = std::dynamic_pointer_cast<mrpt::maps::CSimpleMap>(object);
  if (!map)
    throw std::runtime_error(path + ": no simplemap" +
                             (object ? ", but a " + className(*object) : std::string()));
  static_cast<void>(file.next());  // finds what is damaged behind the map

  std::vector<PosedObservation> scans;
  std::size_t skipped = 0;
  for (const auto& [pose, frame] : *map)
  {
    const bool usable = pose && frame && isFinite(pose->getMeanVal());
    if (!usable) ++skipped;
    if (!usable) continue;
    const auto [covariance, mean] = pose->getCovarianceAndMean();
    for (const auto& obs : *frame)
      if (obs && isScan(*obs)) scans.push_back({obs, mean, heightCovariance(covariance)});
  }
  if (skipped > 0)
    warn(log, path + ": " + std::to_string(skipped) + " of " +
                  params::counted(map->size(), "keyframe") +
                  " left out: no observations or no finite pose");
  if (scans.empty()) throw std::runtime_error(path + ": no scans in this simplemap");
  findExternalFiles(scans, path, log);
  return scans;
}

namespace
{
constexpr const char* kOrStatic = " (if the sensor stood still, say so: --static)";

/** Of a log without poses a single scan is of use. */
std::vector<PosedObservation> scansWithoutPoses(const Log& log, const std::string& path)
{
  const std::string faults = log.poses().faults();
  if (log.scans() > 1 && log.scans3D() != 1)
    throw std::runtime_error(
        path + ": " + std::to_string(log.scans()) + " scans but no " +
        (faults.empty() ? "robot poses and no odometry" : "pose that is of use, only " + faults) +
        kOrStatic);
  log.warnOfFaultyPoses();
  return log.scans() == 1 ? log.atIdentity() : log.only3DAtIdentity();
}

/** Why no scan, or no 3D scan if there are any, has a pose. */
std::string whyNoneIsPosed(const Log& log, const LeftOut& lost, double maxGap)
{
  const bool only3D = log.scans3D() > 0;
  const std::size_t wanted = only3D ? log.scans3D() : log.scans();
  const std::string kind = wanted == log.scans() ? "scan" : "3D scan";
  if (log.lacksTimes(only3D))
    return (wanted == 1 ? "its " + kind + " has"
                        : "all " + params::counted(wanted, kind) + " have") +
           " no time stamp" + kOrStatic;
  return std::string("no ") + (only3D ? "3D" : "2D") +
         " scan lies within the time span of the poses, give or take " +
         mrpt::format("%g s, and within %g s of both poses around it (--max-pose-gap): ",
                      PoseTrack::kTolerance, maxGap) +
         lost.reasons();
}

/** The scans whose pose is known. Errors name the file. */
std::vector<PosedObservation> scansOf(const Log& log, const RawlogOptions& options,
                                      const std::string& path)
{
  requireScans(log, path);
  if (options.staticSensor) return log.atIdentity();
  if (log.poses().empty()) return scansWithoutPoses(log, path);
  log.warnOfFaultyPoses();
  LeftOut lost(options.maxPoseGap);
  auto scans = posedScans(log, options, path, lost);
  if (scans.empty() || (log.scans3D() > 0 && !has3DScan(scans)))
    throw std::runtime_error(path + ": " + whyNoneIsPosed(log, lost, options.maxPoseGap));
  log.warnOf(lost);
  return scans;
}
}  // namespace

std::vector<PosedObservation> readRawlog(const std::string& path, const RawlogOptions& options,
                                         const COutputLogger* logger)
{
  files::ObjectFile file(path);
  return readRawlog(file, options, logger);
}

std::vector<PosedObservation> readRawlog(files::ObjectFile& file, const RawlogOptions& options,
                                         const COutputLogger* logger)
{
  auto scans = scansOf(readLog(file, logger), options, file.path());
  findExternalFiles(scans, file.path(), logger);
  return scans;
}

}  // namespace mrpt_mapconv::observation
