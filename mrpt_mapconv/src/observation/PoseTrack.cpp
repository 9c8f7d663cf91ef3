#include <mrpt/math/CQuaternion.h>
#include <mrpt/math/slerp.h>
#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/observation/PoseTrack.h>

#include <algorithm>
#include <iterator>

namespace mrpt_mapconv::observation
{
using mrpt::poses::CPose3D;
using mrpt::system::TTimeStamp;

namespace
{
double linear(double a, double b, double share) { return a + (b - a) * share; }

CPose3D between(const CPose3D& a, const CPose3D& b, double share)
{
  mrpt::math::CQuaternionDouble turnA, turnB, turn;
  a.getAsQuaternion(turnA);
  b.getAsQuaternion(turnB);
  mrpt::math::slerp(turnA, turnB, share, turn);
  turn.normalize();
  return CPose3D(turn, linear(a.x(), b.x(), share), linear(a.y(), b.y(), share),
                 linear(a.z(), b.z(), share));
}

}  // namespace

bool PoseTrack::insert(TTimeStamp time, const CPose3D& pose,
                       const std::optional<HeightCovariance>& covariance)
{
  if (time == INVALID_TIMESTAMP || !isFinite(pose)) return false;
  m_poses[time] = {pose, covariance};
  return true;
}

std::optional<CPose3D> PoseTrack::knownAt(TTimeStamp time) const
{
  const auto found = m_poses.find(time);
  if (found == m_poses.end()) return std::nullopt;
  return found->second.mean;
}

mrpt::math::TBoundingBox PoseTrack::bounds() const
{
  auto box = mrpt::math::TBoundingBox::PlusMinusInfinity();
  for (const auto& [time, pose] : m_poses) box.updateWithPoint(pose.mean.translation());
  return box;
}

PoseTrack::Coverage PoseTrack::coverage(TTimeStamp time, double maxGap) const
{
  using mrpt::system::timeDifference;
  if (time == INVALID_TIMESTAMP) return Coverage::NoTime;
  if (m_poses.empty()) return Coverage::Outside;
  const auto next = m_poses.lower_bound(time);
  if (next == m_poses.end())
    return timeDifference(m_poses.rbegin()->first, time) > kTolerance ? Coverage::Outside
                                                                      : Coverage::Known;
  if (next->first == time) return Coverage::Known;
  const double ahead = timeDifference(time, next->first);
  if (next == m_poses.begin()) return ahead > kTolerance ? Coverage::Outside : Coverage::Known;
  const double behind = timeDifference(std::prev(next)->first, time);
  return std::max(ahead, behind) > maxGap ? Coverage::Gap : Coverage::Known;
}

PoseTrack::Around PoseTrack::around(TTimeStamp time) const
{
  using mrpt::system::timeDifference;
  const auto next = m_poses.lower_bound(time);
  if (next == m_poses.end()) return {m_poses.rbegin()->second, m_poses.rbegin()->second, 0};
  if (next->first == time || next == m_poses.begin()) return {next->second, next->second, 0};
  const auto previous = std::prev(next);
  return {previous->second, next->second,
          timeDifference(previous->first, time) / timeDifference(previous->first, next->first)};
}

std::optional<CPose3D> PoseTrack::at(TTimeStamp time, double maxGap) const
{
  if (coverage(time, maxGap) != Coverage::Known) return std::nullopt;
  const Around poses = around(time);
  if (&poses.before == &poses.after) return poses.before.mean;
  return between(poses.before.mean, poses.after.mean, poses.share);
}

std::optional<HeightCovariance> PoseTrack::covarianceAt(TTimeStamp time, double maxGap) const
{
  if (coverage(time, maxGap) != Coverage::Known) return std::nullopt;
  const Around poses = around(time);
  if (!poses.before.covariance || !poses.after.covariance) return std::nullopt;
  HeightCovariance out = *poses.before.covariance;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      out(row, column) =
          linear(out(row, column), (*poses.after.covariance)(row, column), poses.share);
  return out;
}

double PoseTrack::gapAt(TTimeStamp time) const
{
  const auto next = m_poses.lower_bound(time);
  if (next == m_poses.begin() || next == m_poses.end()) return 0;
  return mrpt::system::timeDifference(std::prev(next)->first, next->first);
}

}  // namespace mrpt_mapconv::observation
