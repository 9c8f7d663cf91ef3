// Returns at a sensor's maximum range, or beyond it, are none.
#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>

#include <limits>

namespace
{
using namespace mrpt_mapconv::observation;
using mrpt::math::TPoint3Df;
using Points = std::vector<TPoint3Df>;

void expectNear(const Points& expected, const Points& points)
{
  ASSERT_EQ(expected.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT((expected[i] - points[i]).norm(), 1e-4f) << i << ": " << points[i];
}

void expectSeen(const mrpt::obs::CObservation& scan, const Points& returns, const Points& none)
{
  const auto seen = sensorPoints(scan, {});
  ASSERT_TRUE(seen);
  expectNear(returns, seen->points);
  expectNear(none, seen->noReturns);
}

mrpt::obs::CObservation2DRangeScan scan2D(const std::vector<float>& ranges, float maxRange)
{
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(M_PI);  // of three: right, ahead, left
  scan.maxRange = maxRange;
  scan.resizeScanAndAssign(ranges.size(), 0, true);
  for (std::size_t i = 0; i < ranges.size(); ++i) scan.setScanRange(i, ranges[i]);
  return scan;
}

TEST(MaxRange, OfA2DScan)
{
  auto scan = scan2D({4.1f, 2, 9}, 4.1f);
  expectSeen(scan, {{2, 0, 0}}, {{0, -4.1f, 0}, {0, 4.1f, 0}});
  scan.setScanRangeValidity(0, false);
  scan.setScanRange(2, 0);
  expectSeen(scan, {{2, 0, 0}}, {});
}

TEST(MaxRange, ThatIsNotSetLimitsNothing)
{
  for (const float unset : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity()})
    expectSeen(scan2D({1, 200, 3}, unset), {{0, -1, 0}, {200, 0, 0}, {0, 3, 0}}, {});
}

TEST(MaxRange, RangesThatAreNoNumbersStayWhatTheyAre)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  expectSeen(scan2D({nan, 2, infinity}, 5), {{2, 0, 0}}, {});
}

/** One row; pixel c looks along (1, 1−c, 0). */
mrpt::obs::CObservation3DRangeScan depthImage(const std::vector<std::uint16_t>& depths)
{
  mrpt::obs::CObservation3DRangeScan scan;
  const auto width = static_cast<std::uint32_t>(depths.size());
  scan.cameraParams.ncols = width;
  scan.cameraParams.nrows = 1;
  scan.cameraParams.setIntrinsicParamsFromValues(1, 1, 1, 0);
  scan.hasRangeImage = true;
  scan.maxRange = 4.1f;
  scan.rangeImage.setZero(1, static_cast<int>(width));
  for (std::uint32_t i = 0; i < width; ++i)
    scan.rangeImage(0, static_cast<int>(i)) = depths[i];  // [mm]
  return scan;
}

TEST(MaxRange, OfADepthImageIsADepth)
{
  expectSeen(depthImage({4100, 4099, 0, 9000}), {{4.099f, 0, 0}},
             {{4.1f, 4.1f, 0}, {4.1f, -8.2f, 0}});
}

TEST(MaxRange, OfARangeImageIsARange)
{
  auto scan = depthImage({4100, 4099, 3000, 0});
  scan.range_is_depth = false;
  const float side = 4.1f * std::sqrt(0.5f), near = 3 * std::sqrt(0.5f);
  expectSeen(scan, {{4.099f, 0, 0}, {near, -near, 0}}, {{side, side, 0}});
}

TEST(MaxRange, OfARangeCamerasPoints)
{
  mrpt::obs::CObservation3DRangeScan scan;
  scan.maxRange = 4;
  scan.hasPoints3D = true;
  scan.resizePoints3DVectors(3);
  scan.points3D_x = {4, 3, 8};
  scan.points3D_y = {3, 3, 2};
  scan.points3D_z = {0, 0, 4};
  expectSeen(scan, {{3, 3, 0}}, {{4, 3, 0}, {4, 1, 2}});
}

TEST(MaxRange, OfARotatingScan)
{
  mrpt::obs::CObservationRotatingScan scan;
  scan.rangeResolution = 0.01;
  scan.maxRange = 5;
  scan.startAzimuth = 0;
  scan.azimuthSpan = M_PI;
  scan.rangeImage.setZero(1, 3);
  scan.rangeImage(0, 0) = 500;
  scan.rangeImage(0, 1) = 499;
  expectSeen(scan, {{0, 4.99f, 0}}, {{5, 0, 0}});

  scan.lidarModel = "VLP-16";
  scan.rangeImage.setZero(16, 3);
  scan.rangeImage(0, 1) = 800;  // 15 degrees down
  scan.rangeImage(0, 2) = 50;   // nearer than minRange
  const auto down = static_cast<float>(M_PI / 12);
  expectSeen(scan, {}, {{0, 5 * std::cos(down), -5 * std::sin(down)}});
}

TEST(MaxRange, OfAVelodyneScansCloud)
{
  mrpt::obs::CObservationVelodyneScan scan;
  scan.maxRange = 5;
  scan.point_cloud.x = {3, 6};
  scan.point_cloud.y = {0, 0};
  scan.point_cloud.z = {0, 8};
  scan.point_cloud.intensity = {0, 0};
  expectSeen(scan, {{3, 0, 0}}, {{3, 0, 4}});
}

TEST(MaxRange, IsUnknownOfAPointCloud)
{
  mrpt::obs::CObservationPointCloud scan;
  scan.pointcloud = mrpt::maps::CSimplePointsMap::Create();
  scan.pointcloud->insertPoint(1000, 0, 0);
  expectSeen(scan, {{1000, 0, 0}}, {});
}
}  // namespace
