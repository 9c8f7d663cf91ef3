// Logs of real sensors, read from the file to the points.
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <algorithm>
#include <cmath>

#include "support/ScanFixtures.h"

namespace mrpt_mapconv::observation
{
using namespace fixtures;
using mrpt::math::TPoint3Df;

namespace
{
/** Reads the only scan of one of MRPT's logs; its points in the sensor frame. */
std::vector<TPoint3Df> pointsOfMrptLog(const std::string& name)
{
  const auto scans = readRawlog(kMrptData + name);
  EXPECT_EQ(scans.size(), 1u);
  const auto before = bytes(*scans[0].observation);
  const auto got = sensorPoints(*scans[0].observation, {});
  EXPECT_EQ(bytes(*scans[0].observation), before);
  return got ? got->points : std::vector<TPoint3Df>();
}
}  // namespace

TEST(RealScans, RangeCamera)
{
  const auto scans = readRawlog(std::string(kMrptData) + "tests_rgbd.rawlog");
  const auto& obs = dynamic_cast<mrpt::obs::CObservation3DRangeScan&>(*scans.at(0).observation);
  obs.load();
  std::size_t returns = 0;
  for (int r = 0; r < obs.rangeImage.rows(); ++r)
    for (int c = 0; c < obs.rangeImage.cols(); ++c) returns += obs.rangeImage(r, c) != 0;
  EXPECT_EQ(pointsOfMrptLog("tests_rgbd.rawlog").size(), returns);
}

TEST(RealScans, Laser)
{
  // 361 rays over 180°, two without return.
  const auto points = pointsOfMrptLog("rot_scan_2d.rawlog");
  EXPECT_EQ(points.size(), 359u);
  for (const auto& p : points)
  {
    EXPECT_EQ(p.z, 0.0f);
    EXPECT_GT(p.x, -1e-4f);
  }
}

TEST(RealScans, VelodyneAndTheRotatingScanMadeFromItAgree)
{
  const auto velodyne = pointsOfMrptLog("test_velodyne_VLP16.rawlog");
  const auto rotating = pointsOfMrptLog("rot_scan_velodyne.rawlog");
  // MRPT 2.5 decodes the first of the two firings in a block, in both classes.
  EXPECT_EQ(velodyne.size(), 11305u);
  ASSERT_EQ(rotating.size(), velodyne.size());
  for (const auto& p : velodyne)
  {
    double nearest = 1e9;
    for (const auto& q : rotating) nearest = std::min(nearest, static_cast<double>((p - q).norm()));
    ASSERT_LT(nearest, 0.004 * static_cast<double>(p.norm())) << p;
  }
}

TEST(RealScans, Logs)
{
  for (const char* name : {"test_velodyne_VLP16", "tests_rgbd", "rot_scan_velodyne", "rot_scan_2d"})
    EXPECT_EQ(readRawlog(kMrptData + std::string(name) + ".rawlog").size(), 1u) << name;
}

TEST(RealScans, VelodyneSequence)
{
#ifdef MRPT_MAPCONV_SHARED_DIR
  const std::string path = std::string(MRPT_MAPCONV_SHARED_DIR) + "/vlp16_3scans.rawlog";
#else
  const std::string path;
#endif
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no vlp16_3scans.rawlog";
  EXPECT_TRUE(contains(messageOf([&path] { readRawlog(path); }), "3 scans but no robot poses"));
  const auto scans = readRawlog(path, {true});
  ASSERT_EQ(scans.size(), 3u);
  for (const auto& scan : scans)
  {
    const auto before = bytes(*scan.observation);
    const auto got = sensorPoints(*scan.observation, scan.robotPose);
    EXPECT_EQ(bytes(*scan.observation), before);
    ASSERT_TRUE(got);
    EXPECT_NEAR(got->sensorPose.z(), 1.8, 1e-6);
    EXPECT_GT(got->points.size(), 6000u);
    for (const auto& p : got->points)
    {
      ASSERT_GE(p.norm(), 0.999f);
      ASSERT_LE(std::abs(std::asin(p.z / p.norm())), mrpt::DEG2RAD(15.01f));
    }
  }
}

TEST(RealScans, SimpleMap)
{
  const auto scans = readSimpleMap(std::string(kMrptData) + "localization_demo.simplemap.gz");
  EXPECT_FALSE(scans.empty());
}

}  // namespace mrpt_mapconv::observation
