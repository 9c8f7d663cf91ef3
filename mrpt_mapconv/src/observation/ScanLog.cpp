#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt_mapconv/observation/ExternalFiles.h>
#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/PoseTrack.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

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

/** The increment that a collection of actions stands for; nothing if it holds no movement. */
std::optional<CPose3D> movement(const CActionCollection& actions)
{
  using mrpt::obs::CActionRobotMovement2D;
  using mrpt::obs::CActionRobotMovement3D;
  if (const auto move = actions.getActionByClass<CActionRobotMovement3D>())
    return move->poseChange.mean;
  if (const auto move = actions.getActionByClass<CActionRobotMovement2D>())
  {
    if (move->estimationMethod == CActionRobotMovement2D::emOdometry)
      return CPose3D(move->rawOdometryIncrementReading);
    if (move->poseChange) return CPose3D(move->poseChange->getMeanVal());
  }
  return std::nullopt;
}

using Tracks = std::map<std::string, PoseTrack>;  //!< by the label of their source

/** Why scans have no pose. */
class LeftOut
{
 public:
  void add(const PoseTrack& track, mrpt::system::TTimeStamp time, double maxGap)
  {
    const auto coverage = track.coverage(time, maxGap);
    m_noTime += coverage == PoseTrack::Coverage::NoTime;
    m_outside += coverage == PoseTrack::Coverage::Outside;
    if (coverage != PoseTrack::Coverage::Gap) return;
    ++m_inGaps;
    m_longestGap = std::max(m_longestGap, track.gapAt(time));
  }

  std::string reasons(double maxGap) const
  {
    std::string text;
    const auto append = [&text](std::size_t count, const std::string& why)
    {
      if (count == 0) return;
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + why;
    };
    append(
        m_inGaps,
        mrpt::format("in gaps between the poses (the longest is %.1f s; both poses around a scan "
                     "must be within %g s of it)",
                     m_longestGap, maxGap));
    append(m_outside, "outside the time span of the poses");
    append(m_noTime, "without a time stamp");
    return text;
  }

 private:
  std::size_t m_inGaps = 0, m_outside = 0, m_noTime = 0;
  double m_longestGap = 0;
};

/** The parts of a rawlog that matter here. */
class Log
{
 public:
  explicit Log(const COutputLogger* log) : m_log(log) {}

  /** Takes an entry of the log; other objects are passed over but for their name. */
  void add(const CSerializable::Ptr& entry)
  {
    if (const auto actions = std::dynamic_pointer_cast<CActionCollection>(entry))
      add(*actions);
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
  bool hasPoses() const { return m_hasMoved || !m_robotPoses.empty() || !m_odometry.empty(); }

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
      warn(m_log, std::to_string(lost) + " 2D scans are left out: the log has no poses for them");
    return scans;
  }

  /** The scans whose pose is known. */
  std::vector<PosedObservation> posed(const RawlogOptions& options) const
  {
    const double maxGap = options.maxPoseGap;
    if (m_badPoses > 0)
      warn(m_log, std::to_string(m_badPoses) +
                      " poses without a time or with NaN or infinite coordinates are left out");
    if (!options.poseSource.empty()) return along(labelled(options.poseSource), maxGap);
    if (!m_robotPoses.empty()) return along(longest(m_robotPoses), maxGap);
    if (!m_odometry.empty()) return along(longest(m_odometry), maxGap);
    return m_scans;
  }

  /** Class of the last object that is no entry of a rawlog; empty if there was none. */
  const std::string& foreign() const { return m_foreign; }

 private:
  void add(const CActionCollection& actions)
  {
    const auto increment = movement(actions);
    if (!increment) return;
    if (!isFinite(*increment))
    {
      ++m_badPoses;
      return;
    }
    m_summedUp = m_summedUp + *increment;
    m_hasMoved = true;
  }

  void add(const CObservation::Ptr& obs)
  {
    if (!obs) return;
    if (const auto pose = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(obs))
      add(m_robotPoses, *obs, pose->pose.mean + (-pose->sensorPose));
    else if (const auto odo = std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(obs))
      add(m_odometry, *obs, CPose3D(odo->odometry));
    else if (isScan(*obs))
      m_scans.push_back({obs, m_summedUp});
  }

  void add(Tracks& tracks, const CObservation& obs, const CPose3D& pose)
  {
    if (tracks[obs.sensorLabel].insert(obs.timestamp, pose)) return;
    ++m_badPoses;
    if (tracks[obs.sensorLabel].empty()) tracks.erase(obs.sensorLabel);
  }

  const PoseTrack& longest(const Tracks& tracks) const
  {
    const auto shorter = [](const auto& a, const auto& b)
    { return a.second.size() < b.second.size(); };
    const auto most = std::max_element(tracks.begin(), tracks.end(), shorter);
    if (m_robotPoses.size() + m_odometry.size() > 1)
      warn(m_log, "poses come from several sources: " + sources() + "; those of '" + most->first +
                      "' are used (--pose-source LABEL chooses others)");
    return most->second;
  }

  /** The track with a label. */
  const PoseTrack& labelled(const std::string& label) const
  {
    for (const auto* tracks : {&m_robotPoses, &m_odometry})
      if (const auto track = tracks->find(label); track != tracks->end()) return track->second;
    throw std::runtime_error("no poses are labelled '" + label + "'; there are: " +
                             (sources().empty() ? std::string("none") : sources()));
  }

  /** Their labels and how many poses each has. */
  std::string sources() const
  {
    std::string text;
    for (const auto* tracks : {&m_robotPoses, &m_odometry})
      for (const auto& [label, track] : *tracks)
        text += (text.empty() ? "'" : ", '") + label + "' (" + std::to_string(track.size()) +
                (tracks == &m_odometry ? " of odometry)" : ")");
    return text;
  }

  std::vector<PosedObservation> along(const PoseTrack& track, double maxGap) const
  {
    std::vector<PosedObservation> out;
    LeftOut lost;
    for (const auto& scan : m_scans)
      if (const auto pose = track.at(scan.observation->timestamp, maxGap))
        out.push_back({scan.observation, *pose});
      else
        lost.add(track, scan.observation->timestamp, maxGap);
    if (out.size() < m_scans.size())
      warn(m_log, std::to_string(m_scans.size() - out.size()) + " of " +
                      std::to_string(m_scans.size()) +
                      " scans are left out: " + lost.reasons(maxGap));
    return out;
  }

  const COutputLogger* m_log;
  std::vector<PosedObservation> m_scans;  //!< at the poses that the actions give
  Tracks m_robotPoses, m_odometry;
  CPose3D m_summedUp;
  bool m_hasMoved = false;
  std::string m_foreign;
  std::size_t m_badPoses = 0;
};

bool has3DScan(const std::vector<PosedObservation>& scans)
{
  return std::any_of(scans.begin(), scans.end(),
                     [](const PosedObservation& s) { return is3DScan(*s.observation); });
}

/** Errors name the file. */
std::vector<PosedObservation> posedScans(const Log& log, const RawlogOptions& options,
                                         const std::string& path)
try
{
  return log.posed(options);
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
    for (const auto& obs : *frame)
      if (obs && isScan(*obs)) scans.push_back({obs, pose->getMeanVal()});
  }
  if (skipped > 0)
    warn(log, path + ": " + std::to_string(skipped) + " of " + std::to_string(map->size()) +
                  " keyframes are left out: they have no observations or no finite pose");
  if (scans.empty()) throw std::runtime_error(path + ": no scans in this simplemap");
  findExternalFiles(scans, path, log);
  return scans;
}

namespace
{
/** The scans whose pose is known. Errors name the file. */
std::vector<PosedObservation> scansOf(const Log& log, const RawlogOptions& options,
                                      const std::string& path)
{
  requireScans(log, path);
  if (options.staticSensor) return log.atIdentity();
  const std::string kind = log.scans3D() > 0 ? "3D scan" : "2D scan";
  if (!log.hasPoses())
  {
    if (log.scans() == 1) return log.atIdentity();
    if (log.scans3D() == 1) return log.only3DAtIdentity();
    throw std::runtime_error(
        path + ": " + std::to_string(log.scans3D() > 0 ? log.scans3D() : log.scans()) + " " + kind +
        "s but no robot poses and no odometry (if the sensor stood still, say so: --static)");
  }
  auto scans = posedScans(log, options, path);
  if (scans.empty() || (log.scans3D() > 0 && !has3DScan(scans)))
    throw std::runtime_error(path + ": no " + kind +
                             " lies within the time span of the poses, give or take " +
                             mrpt::format("%.1f s, and within %g s of both poses around it",
                                          PoseTrack::kTolerance, options.maxPoseGap));
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
