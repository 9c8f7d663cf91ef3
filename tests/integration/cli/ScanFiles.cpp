#include "ScanFiles.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
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

mrpt::obs::CObservation::Ptr cloudOf(float x, float y, float z, double seconds)
{
  auto points = mrpt::maps::CSimplePointsMap::Create();
  points->insertPointFast(x, y, z);
  auto scan = mrpt::obs::CObservationPointCloud::Create();
  scan->pointcloud = points;
  scan->sensorPose = CPose3D(0.05, 0.05, 2.05, 0, 0, 0);
  scan->timestamp = at(seconds);
  scan->sensorLabel = "lidar";
  return scan;
}
}  // namespace

mrpt::obs::CObservation::Ptr lookDown(double seconds) { return cloudOf(0, 0, -2, seconds); }
mrpt::obs::CObservation::Ptr badPoint(float x, double seconds) { return cloudOf(x, 0, 1, seconds); }

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
  for (const double x : xs)
  {
    mrpt::poses::CPose3DPDFGaussian pose(CPose3D(x, 0, 0, 0, 0, 0));
    mrpt::obs::CSensoryFrame frame;
    frame.insert(lookDown(0));
    map->insert(pose, frame);
  }
  writeObjects(path, {map}, gzipped);
}

}  // namespace mrpt_mapconv::testing
