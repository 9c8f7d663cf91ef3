#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/observation/CloudTimes.h>
#include <mrpt_mapconv/observation/PoseCovariance.h>
#include <mrpt_mapconv/observation/SensorPoints.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace mrpt_mapconv::observation
{
/** Points of a cloud that were seen shortly after each other, as if from one place. */
struct CloudScan
{
  SensorPoints points;  //!< the robot's pose is the sensor's: nobody knows how it is mounted
  std::optional<HeightCovariance> poseCovariance;  //!< if the trajectory has it
};

/** Takes a cloud apart into scans of at most kScanTime, in the order of time. Each lies in the map
 * as the cloud has it; only from where it was seen is that of the middle one of its points, and
 * ranges and what follows from them are off by what the sensor moved in between. */
class CloudScans
{
 public:
  static constexpr double kScanTime = 0.1;  //!< [s], a turn of most lidars

  /** \param cloud with times \param sensor its poses, in the cloud's coordinates [m] before its
   * origin was taken off; both must outlive this
   * \exception std::invalid_argument for a cloud without times */
  CloudScans(const cloud::PointCloud& cloud, const PoseTrack& sensor, const CloudTimes& times);

  std::size_t size() const { return m_begins.size() - 1; }
  /** \param index below size() */
  CloudScan scan(std::size_t index) const;

  std::size_t points() const { return m_order.size(); }  //!< of all scans
  std::size_t withheld() const { return m_withheld; }    //!< that the cloud marks as not to be used
  std::size_t uncovered() const { return m_uncovered; }  //!< at whose time there is no pose

 private:
  void chooseCovered();
  void split();

  const cloud::PointCloud& m_cloud;
  const PoseTrack& m_sensor;
  CloudTimes m_times;
  std::vector<std::size_t> m_order;   //!< points by time
  std::vector<std::size_t> m_begins;  //!< of scans in m_order, and its end
  std::size_t m_withheld = 0, m_uncovered = 0;
};

}  // namespace mrpt_mapconv::observation
