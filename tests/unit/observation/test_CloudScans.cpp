#include <gtest/gtest.h>
#include <mrpt_mapconv/observation/CloudScans.h>
#include <mrpt_mapconv/observation/TrajectoryFile.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace mrpt_mapconv;
using observation::CloudScans;
using observation::CloudTimes;
using observation::PoseTrack;

namespace
{
constexpr double kX = 448258, kY = 5411929;

/** A sensor that goes 10 m a second along x and looks along y. */
PoseTrack track()
{
  PoseTrack poses;
  for (int t = 0; t <= 2; ++t)
    poses.insert(observation::timeStampOf(t), {kX + 10 * t, kY, 1, M_PI_2, 0, 0},
                 observation::HeightCovariance::Identity());
  return poses;
}

/** Points at (5, 3, 0) in the cloud's frame, seen at these times. */
cloud::PointCloud cloudOf(const std::vector<double>& times)
{
  cloud::PointCloud cloud;
  cloud.origin = {kX, kY, 0};
  cloud.x.assign(times.size(), 5);
  cloud.y.assign(times.size(), 3);
  cloud.z.assign(times.size(), 0);
  cloud.time = times;
  return cloud;
}
}  // namespace

TEST(CloudScans, aPointLiesWhereTheCloudHasItSeenFromWhereTheSensorWas)
{
  const auto cloud = cloudOf({1});
  const auto sensor = track();
  const CloudScans scans(cloud, sensor, {});
  ASSERT_EQ(scans.size(), 1u);
  const auto scan = scans.scan(0);
  EXPECT_NEAR(scan.points.sensorPose.x(), 10, 1e-6);
  EXPECT_NEAR(scan.points.sensorPose.y(), 0, 1e-6);
  EXPECT_TRUE(scan.poseCovariance);
  ASSERT_EQ(scan.points.points.size(), 1u);
  const auto& seen = scan.points.points[0];
  EXPECT_NEAR(seen.x, 3, 1e-5) << "ahead is y";
  EXPECT_NEAR(seen.y, 5, 1e-5);
  EXPECT_NEAR(seen.z, -1, 1e-5);
}

TEST(CloudScans, scansAreATenthOfASecondLongAtMost)
{
  const auto cloud = cloudOf({0.30, 0.05, 0.0, 0.09, 0.125, 0.2, 0.31});
  const auto sensor = track();
  const CloudScans scans(cloud, sensor, {});
  ASSERT_EQ(scans.size(), 3u);
  EXPECT_EQ(scans.points(), 7u);
  EXPECT_EQ(scans.scan(0).points.points.size(), 3u) << "0 to 0.09 s";
  EXPECT_NEAR(scans.scan(0).points.sensorPose.x(), 0.5, 1e-6) << "of the middle point";
  EXPECT_EQ(scans.scan(1).points.points.size(), 2u);
  EXPECT_EQ(scans.scan(2).points.points.size(), 2u);
}

TEST(CloudScans, theUnitOfTimesCountsForScansToo)
{
  CloudTimes times;
  times.unit = 1e-6;
  const auto cloud = cloudOf({0, 90e3, 0.2e6});
  const auto sensor = track();
  EXPECT_EQ(CloudScans(cloud, sensor, times).size(), 2u);
}

TEST(CloudScans, allPointsOfAScanLieWhereTheCloudHasThem)
{
  const auto cloud = cloudOf({0, 0.05, 0.1});
  const auto sensor = track();
  const auto scan = CloudScans(cloud, sensor, {}).scan(0);
  for (const auto& seen : scan.points.points)
  {
    const auto at = scan.points.sensorPose.composePoint(seen.cast<double>());
    EXPECT_NEAR((at - mrpt::math::TPoint3D(5, 3, 0)).norm(), 0, 1e-5);
  }
}

TEST(CloudScans, pointsThatAreNotToBeUsedOrThatNobodySawAreCounted)
{
  auto cloud = cloudOf({1, 7, std::numeric_limits<double>::quiet_NaN(), 1e300, 1});
  cloud.withheld = {0, 0, 0, 0, 1};
  const auto sensor = track();
  const CloudScans scans(cloud, sensor, {});
  EXPECT_EQ(scans.points(), 1u);
  EXPECT_EQ(scans.uncovered(), 3u);
  EXPECT_EQ(scans.withheld(), 1u);
}

TEST(CloudScans, aCloudThatIsNotCoveredHasNoScans)
{
  const auto cloud = cloudOf({7});
  const auto sensor = track();
  EXPECT_EQ(CloudScans(cloud, sensor, {}).size(), 0u);
}

TEST(CloudScans, aCloudWithoutTimesIsRefused)
{
  auto cloud = cloudOf({1});
  cloud.time.clear();
  const auto sensor = track();
  EXPECT_THROW(CloudScans(cloud, sensor, {}), std::invalid_argument);
}
