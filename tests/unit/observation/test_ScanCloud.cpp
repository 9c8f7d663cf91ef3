#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt_mapconv/observation/ScanCloud.h>

#include <cmath>
#include <limits>
#include <memory>

using namespace mrpt_mapconv;

namespace
{
/** Points of a sensor that is 2 m above the robot and looks to its left. */
mrpt::obs::CObservation::Ptr scanOf(const std::vector<mrpt::math::TPoint3Df>& points)
{
  auto scan = mrpt::obs::CObservationPointCloud::Create();
  scan->sensorPose = mrpt::poses::CPose3D(0, 0, 2, M_PI_2, 0, 0);
  auto cloud = mrpt::maps::CSimplePointsMap::Create();
  for (const auto& p : points) cloud->insertPointFast(p.x, p.y, p.z);
  scan->pointcloud = cloud;
  return scan;
}

observation::PosedObservation posed(const mrpt::obs::CObservation::Ptr& scan,
                                    const mrpt::poses::CPose3D& robot)
{
  observation::PosedObservation one;
  one.observation = scan;
  one.robotPose = robot;
  return one;
}
}  // namespace

TEST(ScanCloud, PointsAreAddedInTheMapFrame)
{
  cloud::PointCloud cloud;
  cloud.origin = {448258, 5411929, 0};
  appendScan(posed(scanOf({{3, 0, -1}}), {10, 20, 5, 0, 0, 0}), cloud);
  appendScan(posed(scanOf({{1, 0.5, 0}, {0, 0, 1}}), {10, 20, 5, M_PI, 0, 0}), cloud);
  ASSERT_EQ(cloud.size(), 3U);
  const double right[3][3] = {{10, 23, 6}, {10.5, 19, 7}, {10, 20, 8}};
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(cloud.x[i], right[i][0], 1e-6) << i;
    EXPECT_NEAR(cloud.y[i], right[i][1], 1e-6) << i;
    EXPECT_NEAR(cloud.z[i], right[i][2], 1e-6) << i;
  }
  EXPECT_EQ(cloud.origin.x, 448258) << "poses are less the origin already";
  EXPECT_TRUE(cloud.time.empty());
}

TEST(ScanCloud, WhatIsNoScanAddsNothing)
{
  cloud::PointCloud cloud;
  appendScan(posed(mrpt::obs::CObservationComment::Create(), {}), cloud);
  EXPECT_TRUE(cloud.empty());
}

TEST(ScanCloud, PointsThatAreNotFiniteAreLeftOut)
{
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  cloud::PointCloud cloud;
  appendScan(posed(scanOf({{1, kNan, 0}, {1, 1, 1}}), {}), cloud);
  EXPECT_EQ(cloud.size(), 1U);
}
