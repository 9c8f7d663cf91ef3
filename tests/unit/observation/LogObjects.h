#pragma once

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <limits>

#include "support/ScanFixtures.h"

/** What the tests of logs make logs of. */
namespace mrpt_mapconv::observation
{
using namespace fixtures;
using mrpt::obs::CObservation;
using mrpt::obs::CObservationPointCloud;
using mrpt::poses::CPose3D;

inline mrpt::system::TTimeStamp at(double seconds)
{
  return mrpt::Clock::fromDouble(1e9 + seconds);
}

inline CObservation::Ptr cloudAt(double seconds)
{
  auto scan = CObservationPointCloud::Create();
  scan->timestamp = at(seconds);
  scan->pointcloud = mrpt::maps::CSimplePointsMap::Create();
  scan->pointcloud->insertPoint(1, 2, 3);
  return scan;
}

inline CObservation::Ptr scan2DAt(double seconds)
{
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->timestamp = at(seconds);
  return scan;
}

inline CObservation::Ptr poseAt(double seconds, const CPose3D& pose, const std::string& label = "")
{
  auto obs = mrpt::obs::CObservationRobotPose::Create();
  obs->timestamp = at(seconds);
  obs->sensorLabel = label;
  obs->pose.mean = pose;
  return obs;
}

inline CObservation::Ptr odometryAt(double seconds, double x, double y, double yawDegrees,
                                    const std::string& label = "")
{
  auto obs = mrpt::obs::CObservationOdometry::Create();
  obs->timestamp = at(seconds);
  obs->sensorLabel = label;
  obs->odometry = {x, y, mrpt::DEG2RAD(yawDegrees)};
  return obs;
}

inline CObservation::Ptr withoutTime(const CObservation::Ptr& obs)
{
  obs->timestamp = INVALID_TIMESTAMP;
  return obs;
}

/** Writes a rawlog of these objects. */
inline std::string rawlog(const TempDir& dir,
                          const std::vector<mrpt::serialization::CSerializable::Ptr>& o)
{
  mrpt::obs::CRawlog log;
  for (const auto& object : o) log.insert(object);
  const std::string path = dir.file("test.rawlog");
  EXPECT_TRUE(log.saveToRawLogFile(path));
  return path;
}

inline mrpt::obs::CSensoryFrame::Ptr frame(const std::vector<CObservation::Ptr>& observations)
{
  auto out = mrpt::obs::CSensoryFrame::Create();
  for (const auto& obs : observations) out->insert(obs);
  return out;
}

inline mrpt::obs::CActionCollection::Ptr wheelStep(double x, double y, double yawDegrees)
{
  mrpt::obs::CActionRobotMovement2D move;
  mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmThrun;  // draws at random
  move.computeFromOdometry({x, y, mrpt::DEG2RAD(yawDegrees)}, model);
  auto out = mrpt::obs::CActionCollection::Create();
  out->insert(move);
  return out;
}

inline void expectPose(const CPose3D& got, double x, double y, double z, double yawDegrees)
{
  EXPECT_NEAR(got.x(), x, 1e-6) << got;
  EXPECT_NEAR(got.y(), y, 1e-6) << got;
  EXPECT_NEAR(got.z(), z, 1e-6) << got;
  EXPECT_NEAR(got.yaw(), mrpt::DEG2RAD(yawDegrees), 1e-6) << got;
}

inline std::string rawlogError(const std::string& path)
{
  return messageOf([&path] { readRawlog(path); });
}
inline std::string simpleMapError(const std::string& path)
{
  return messageOf([&path] { readSimpleMap(path); });
}

}  // namespace mrpt_mapconv::observation
