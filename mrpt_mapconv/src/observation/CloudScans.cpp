#include <mrpt_mapconv/observation/CloudScans.h>
#include <mrpt_mapconv/observation/TrajectoryFile.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv::observation
{
mrpt::system::TTimeStamp CloudTimes::stampOf(double cloudTime) const
{
  constexpr double kMost = 1e11;  // [s], 3000 years; a time stamp holds ten times as much
  const double seconds = unit * cloudTime + offset;
  if (!(std::abs(seconds) < kMost)) return INVALID_TIMESTAMP;
  return timeStampOf(seconds);
}

CloudScans::CloudScans(const cloud::PointCloud& cloud, const PoseTrack& sensor,
                       const CloudTimes& times)
    : m_cloud(cloud), m_sensor(sensor), m_times(times)
{
  if (cloud.time.size() != cloud.size())
    throw std::invalid_argument(
        "the cloud has no times, so nobody knows from where a point was seen");
  chooseCovered();
  split();
}

void CloudScans::chooseCovered()
{
  m_order.reserve(m_cloud.size());
  for (std::size_t i = 0; i < m_cloud.size(); ++i)
  {
    const bool isWithheld = !m_cloud.withheld.empty() && m_cloud.withheld[i] != 0;
    const bool isCovered = m_sensor.coverage(m_times.stampOf(m_cloud.time[i]), m_times.maxGap) ==
                           PoseTrack::Coverage::Known;
    if (isWithheld)
      ++m_withheld;
    else if (!isCovered)
      ++m_uncovered;
    else
      m_order.push_back(i);
  }
}

void CloudScans::split()
{
  const auto& time = m_cloud.time;
  std::stable_sort(m_order.begin(), m_order.end(),
                   [&time](std::size_t a, std::size_t b) { return time[a] < time[b]; });
  m_begins = {0};
  for (std::size_t i = 1; i < m_order.size(); ++i)
    if (m_times.unit * (time[m_order[i]] - time[m_order[m_begins.back()]]) > kScanTime)
      m_begins.push_back(i);
  if (!m_order.empty()) m_begins.push_back(m_order.size());
}

CloudScan CloudScans::scan(std::size_t index) const
{
  const std::size_t begin = m_begins.at(index), end = m_begins.at(index + 1);
  const auto stamp = m_times.stampOf(m_cloud.time[m_order[begin + (end - begin) / 2]]);
  CloudScan scan;
  auto& pose = scan.points.sensorPose;
  pose = m_sensor.at(stamp, m_times.maxGap).value();
  pose.x_incr(-m_cloud.origin.x);
  pose.y_incr(-m_cloud.origin.y);
  pose.z_incr(-m_cloud.origin.z);
  scan.points.robotPose = pose;
  scan.poseCovariance = m_sensor.covarianceAt(stamp, m_times.maxGap);
  scan.points.points.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i)
  {
    const std::size_t point = m_order[i];
    const auto seen =
        pose.inverseComposePoint({m_cloud.x[point], m_cloud.y[point], m_cloud.z[point]})
            .cast<float>();
    if (seen.sqrNorm() > 0) scan.points.points.push_back(seen);
  }
  return scan;
}

}  // namespace mrpt_mapconv::observation
