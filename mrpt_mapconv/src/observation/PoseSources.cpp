#include "PoseSources.h"

#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <stdexcept>

namespace mrpt_mapconv::observation
{
using mrpt::obs::CActionCollection;
using mrpt::obs::CObservation;
using mrpt::poses::CPose3D;

namespace
{
constexpr const char* kRobotPose = "robotPose";
constexpr const char* kOdometry = "odometry";
constexpr const char* kIncrements = "increments";

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

/** "robotPose:slam", or "robotPose" of those without a label. */
std::string fullName(const std::string& kind, const std::string& label)
{
  return label.empty() ? kind : kind + ":" + label;
}

/** Of the robot, which is not where the sensor is whose pose was observed. */
std::optional<HeightCovariance> covarianceOf(const mrpt::obs::CObservationRobotPose& obs)
{
  if (obs.sensorPose == CPose3D() || !heightCovariance(obs.pose.cov))
    return heightCovariance(obs.pose.cov);
  auto pose = obs.pose;
  pose += -obs.sensorPose;
  return heightCovariance(pose.cov);
}
}  // namespace

bool PoseSources::add(const CObservation& obs)
{
  if (const auto* pose = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&obs))
    return add(m_robotPoses, obs, pose->pose.mean + (-pose->sensorPose), covarianceOf(*pose));
  if (const auto* odometry = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&obs))
    return add(m_odometry, obs, CPose3D(odometry->odometry), {});
  return false;
}

bool PoseSources::add(Tracks& tracks, const CObservation& obs, const CPose3D& pose,
                      const std::optional<HeightCovariance>& covariance)
{
  if (obs.timestamp == INVALID_TIMESTAMP)
    ++m_withoutTime;
  else if (!isFinite(pose))
    ++m_notFinite;
  else
    tracks[obs.sensorLabel].insert(obs.timestamp, pose, covariance);
  return true;
}

void PoseSources::add(const CActionCollection& actions)
{
  const auto increment = movement(actions);
  if (!increment) return;
  if (!isFinite(*increment))
  {
    ++m_notFinite;
    return;
  }
  m_summedUp = m_summedUp + *increment;
  ++m_increments;
}

std::string PoseSources::faults() const
{
  std::string text;
  if (m_withoutTime > 0) text = params::counted(m_withoutTime, "pose") + " without a time stamp";
  if (m_notFinite > 0)
    text += (text.empty() ? "" : ", ") + params::counted(m_notFinite, "pose") +
            " with NaN or infinite coordinates";
  return text;
}

std::vector<PoseSources::Source> PoseSources::sources() const
{
  std::vector<Source> all;
  for (const auto& [label, track] : m_robotPoses)
    all.push_back({kRobotPose, label, label, track.size(), &track});
  for (const auto& [label, track] : m_odometry)
    all.push_back({kOdometry, label, label, track.size(), &track});
  if (m_increments > 0) all.push_back({kIncrements, "", "", m_increments, nullptr});
  // A label is the name of a source unless it has none, or shares it.
  for (auto& source : all)
  {
    const auto isCalledSo = [&source](const Source& other)
    { return other.label == source.label || other.kind == source.label; };
    if (source.label.empty() || std::count_if(all.begin(), all.end(), isCalledSo) > 1)
      source.name = fullName(source.kind, source.label);
  }
  return all;
}

const PoseTrack* PoseSources::choose(const std::optional<std::string>& wanted,
                                     const mrpt::system::COutputLogger* log) const
{
  const auto all = sources();
  std::string list;
  for (const auto& source : all)
    list += (list.empty() ? "'" : ", '") + source.name + "' (" + std::to_string(source.poses) + ")";
  if (wanted)
  {
    const auto isNamed = [&wanted](const Source& source)
    { return *wanted == source.name || *wanted == fullName(source.kind, source.label); };
    const auto isLabelled = [&wanted](const Source& source)
    { return *wanted == source.label && source.track != nullptr; };
    auto found = std::find_if(all.begin(), all.end(), isNamed);
    if (found == all.end()) found = std::find_if(all.begin(), all.end(), isLabelled);
    if (found != all.end()) return found->track;
    throw std::runtime_error("no poses are labelled '" + *wanted + "'; there are: " + list);
  }
  const auto isBetter = [&all](const Source& a, const Source& b)
  { return a.kind == all.front().kind && (b.kind != a.kind || a.poses > b.poses); };
  const auto best = std::min_element(all.begin(), all.end(), isBetter);
  if (all.size() > 1 && log)
    log->logStr(mrpt::system::LVL_WARN, "poses come from several sources: " + list +
                                            "; those of '" + best->name +
                                            "' are used (--pose-source chooses others)");
  return best->track;
}

}  // namespace mrpt_mapconv::observation
