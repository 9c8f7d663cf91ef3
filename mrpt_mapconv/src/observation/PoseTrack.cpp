#include <mrpt/math/CQuaternion.h>
#include <mrpt/math/slerp.h>
#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/observation/PoseTrack.h>

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

bool PoseTrack::insert(TTimeStamp time, const CPose3D& pose)
{
  if (time == INVALID_TIMESTAMP || !isFinite(pose)) return false;
  m_poses[time] = pose;
  return true;
}

std::optional<CPose3D> PoseTrack::at(TTimeStamp time) const
{
  using mrpt::system::timeDifference;
  if (m_poses.empty() || time == INVALID_TIMESTAMP) return std::nullopt;
  const auto next = m_poses.lower_bound(time);
  if (next == m_poses.end())
  {
    const auto& [lastTime, last] = *std::prev(next);
    if (timeDifference(lastTime, time) > kTolerance) return std::nullopt;
    return last;
  }
  if (next->first == time) return next->second;
  if (next == m_poses.begin())
  {
    if (timeDifference(time, next->first) > kTolerance) return std::nullopt;
    return next->second;
  }
  const auto previous = std::prev(next);
  const double share =
      timeDifference(previous->first, time) / timeDifference(previous->first, next->first);
  return between(previous->second, next->second, share);
}

}  // namespace mrpt_mapconv::observation
