#include "ScanFiles.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

namespace mrpt_mapconv::testing
{
namespace
{
using mrpt::poses::CPose3D;

mrpt::Clock::time_point at(double seconds) { return mrpt::Clock::fromDouble(1.6e9 + seconds); }

/** \param points in the sensor's frame */
mrpt::obs::CObservation::Ptr cloudOf(const std::vector<mrpt::math::TPoint3Df>& points,
                                     const mrpt::math::TPoint3D& sensor, double seconds)
{
  auto cloud = mrpt::maps::CSimplePointsMap::Create();
  for (const auto& p : points) cloud->insertPointFast(p.x, p.y, p.z);
  auto scan = mrpt::obs::CObservationPointCloud::Create();
  scan->pointcloud = cloud;
  scan->sensorPose = CPose3D(sensor.x, sensor.y, sensor.z, 0, 0, 0);
  scan->timestamp = at(seconds);
  scan->sensorLabel = "lidar";
  return scan;
}

mrpt::obs::CObservation::Ptr pointBelow(float x, float z, double seconds)
{
  return cloudOf({{x, 0, z}}, {0.05, 0.05, 2.05}, seconds);
}

/** A keyframe of one scan. */
void addKeyFrame(mrpt::maps::CSimpleMap& map, double x, const mrpt::obs::CObservation::Ptr& scan)
{
  mrpt::poses::CPose3DPDFGaussian pose(CPose3D(x, 0, 0, 0, 0, 0));
  mrpt::obs::CSensoryFrame frame;
  frame.insert(scan);
  map.insert(pose, frame);
}
}  // namespace

mrpt::obs::CObservation::Ptr lookDown(double seconds) { return pointBelow(0, -2, seconds); }
mrpt::obs::CObservation::Ptr badPoint(float x, double seconds) { return pointBelow(x, 1, seconds); }

mrpt::obs::CObservation::Ptr cloudOn(const std::vector<mrpt::math::TPoint3Df>& points,
                                     const mrpt::math::TPoint3D& sensor, double seconds)
{
  const auto origin = sensor.cast<float>();
  auto seen = points;
  for (auto& point : seen) point -= origin;
  return cloudOf(seen, sensor, seconds);
}

mrpt::obs::CObservation::Ptr scan2D(double seconds)
{
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->aperture = mrpt::DEG2RAD(180.0f);
  scan->maxRange = 10;
  scan->resizeScan(181);
  for (std::size_t i = 0; i < 181; ++i)
  {
    scan->setScanRange(i, 1);
    scan->setScanRangeValidity(i, true);
  }
  scan->timestamp = at(seconds);
  scan->sensorLabel = "scanner";
  return scan;
}

mrpt::obs::CObservation::Ptr robotAt(double x, double seconds)
{
  auto pose = mrpt::obs::CObservationRobotPose::Create();
  pose->pose.mean = CPose3D(x, 0, 0, 0, 0, 0);
  pose->timestamp = at(seconds);
  return pose;
}

mrpt::obs::CObservation::Ptr odometryAt(double x, double seconds)
{
  auto odometry = mrpt::obs::CObservationOdometry::Create();
  odometry->odometry = {x, 0, 0};
  odometry->timestamp = at(seconds);
  return odometry;
}

void writeObjects(const std::string& path, const Objects& objects, bool gzipped)
{
  mrpt::io::CFileOutputStream plain;
  mrpt::io::CFileGZOutputStream zipped;
  if (!(gzipped ? zipped.open(path) : plain.open(path)))
    throw std::runtime_error("cannot write " + path);
  mrpt::io::CStream& stream = gzipped ? static_cast<mrpt::io::CStream&>(zipped) : plain;
  auto archive = mrpt::serialization::archiveFrom(stream);
  for (const auto& object : objects) archive << object;
}

void writeSimpleMap(const std::string& path, const std::vector<double>& xs, bool gzipped)
{
  auto map = mrpt::maps::CSimpleMap::Create();
  for (const double x : xs) addKeyFrame(*map, x, lookDown(0));
  writeObjects(path, {map}, gzipped);
}

void writeSimpleMap(const std::string& path, const std::vector<mrpt::obs::CObservation::Ptr>& scans)
{
  auto map = mrpt::maps::CSimpleMap::Create();
  for (const auto& scan : scans) addKeyFrame(*map, 0, scan);
  writeObjects(path, {map}, true);
}

}  // namespace mrpt_mapconv::testing
