#include <mrpt/img/CImage.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "support/CountAllocations.h"
#include "support/ScanFixtures.h"

namespace mrpt_mapconv::observation
{
using namespace fixtures;
using mrpt::math::TPoint3D;
using mrpt::math::TPoint3Df;

namespace
{
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::vector<TPoint3D> inMap(const SensorPoints& scan)
{
  std::vector<TPoint3D> out;
  for (const auto& p : scan.points) out.push_back(scan.sensorPose.composePoint(TPoint3D(p)));
  return out;
}

/** Reads the observation at robotPose(), expects these points in the map and it unaltered. */
void expectMapPoints(const mrpt::obs::CObservation& obs, const std::vector<TPoint3D>& expected,
                     double tolerance = 1e-5)
{
  const auto before = bytes(obs);
  const auto scan = sensorPoints(obs, robotPose());
  EXPECT_EQ(bytes(obs), before) << "the observation was altered";
  ASSERT_TRUE(scan);
  const auto got = inMap(*scan);
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i)
    EXPECT_LT((got[i] - expected[i]).norm(), tolerance)
        << i << ": " << got[i] << " instead of " << expected[i];
}

mrpt::obs::CObservation2DRangeScan scan2D()
{
  mrpt::obs::CObservation2DRangeScan scan;
  scan.sensorPose = sensorPose();
  scan.aperture = static_cast<float>(M_PI);
  scan.resizeScanAndAssign(3, 0, true);
  for (std::size_t i = 0; i < 3; ++i) scan.setScanRange(i, static_cast<float>(i + 1));
  return scan;
}

/** One row; pixel c looks along (1, 1−c, 0). */
mrpt::obs::CObservation3DRangeScan rangeCamera(unsigned width)
{
  mrpt::obs::CObservation3DRangeScan scan;
  scan.sensorPose = sensorPose();
  scan.cameraParams.ncols = width;
  scan.cameraParams.nrows = 1;
  scan.cameraParams.setIntrinsicParamsFromValues(1, 1, 1, 0);
  scan.hasRangeImage = true;
  scan.rangeUnits = 0.5f;
  scan.rangeImage.setZero(1, static_cast<int>(width));
  scan.rangeImage(0, 0) = 4;  // 2 m deep
  scan.rangeImage(0, 3) = 2;  // 1 m deep; pixels 1 and 2 have no return
  return scan;
}

mrpt::obs::CObservationPointCloud cloud(const std::vector<TPoint3Df>& points)
{
  mrpt::obs::CObservationPointCloud scan;
  scan.sensorPose = sensorPose();
  scan.pointcloud = mrpt::maps::CSimplePointsMap::Create();
  for (const auto& p : points) scan.pointcloud->insertPoint(p);
  return scan;
}

template <class Value>
void put(mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket& packet, std::size_t at,
         Value value)
{
  std::memcpy(reinterpret_cast<char*>(&packet) + at, &value, sizeof(value));
}

/** A VLP-16 that stands still at azimuth 90° (clockwise: its right) and sees 5 m with laser 1,
 * which looks 1° up, and 0.5 m with laser 3. */
mrpt::obs::CObservationVelodyneScan velodyne()
{
  mrpt::obs::CObservationVelodyneScan scan;
  scan.sensorPose = sensorPose();
  scan.minRange = 0.7;
  mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket packet;
  std::memset(static_cast<void*>(&packet), 0, sizeof(packet));
  for (std::size_t block = 0; block < 12; ++block)
  {
    put<std::uint16_t>(packet, 100 * block, 0xeeff);
    put<std::uint16_t>(packet, 100 * block + 2, 9000);
  }
  put<std::uint16_t>(packet, 4 + 3 * 1, 2500);
  put<std::uint16_t>(packet, 4 + 3 * 3, 250);
  packet.laser_return_mode = 0x37;
  packet.velodyne_model_ID = 0x22;
  scan.scan_packets.push_back(packet);
  scan.calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
  return scan;
}

}  // namespace

TEST(ObservationPoints, ComposesTheSensorsPose)
{
  const auto scan = sensorPoints(cloud({{1, 2, 3}}), robotPose());
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->points, (std::vector<TPoint3Df>{{1, 2, 3}}));
  const auto p = scan->sensorPose.composePoint(TPoint3D(1, 2, 3));
  EXPECT_LT((p - TPoint3D(1, 5.5, 5)).norm(), 1e-12);
}

TEST(ObservationPoints, Scan2D)
{
  auto scan = scan2D();  // to the right 1 m, ahead 2 m, to the left 3 m
  expectMapPoints(scan, {{2, 2.5, 2}, {0, 2.5, 3}, {2, 2.5, 6}});
  scan.rightToLeft = false;
  expectMapPoints(scan, {{2, 2.5, 4}, {0, 2.5, 3}, {2, 2.5, 0}});
  scan.setScanRangeValidity(1, false);
  expectMapPoints(scan, {{2, 2.5, 4}, {2, 2.5, 0}});
}

TEST(ObservationPoints, Scan2DOfOneRayLooksAhead)
{
  auto scan = scan2D();
  scan.resizeScanAndAssign(1, 2, true);
  expectMapPoints(scan, {{0, 2.5, 3}});
}

TEST(ObservationPoints, RangeImage)
{
  // Pixels 0 and 3: (2, 2, 0) and (1, −2, 0). MRPT takes another path for widths that 8 divides.
  for (const unsigned width : {5u, 8u})
    expectMapPoints(rangeCamera(width), {{0, 2.5, 5}, {1, 2.5, 1}});
}

TEST(ObservationPoints, RangeImageOfDistances)
{
  auto scan = rangeCamera(8);
  scan.range_is_depth = false;
  const double a = 2 / std::sqrt(2), b = 1 / std::sqrt(5);
  expectMapPoints(scan, {{2 - a, 2.5, 3 + a}, {2 - b, 2.5, 3 - 2 * b}});
}

TEST(ObservationPoints, RangeCamerasOwnPointsComeFirst)
{
  auto scan = rangeCamera(8);
  scan.hasPoints3D = true;
  scan.resizePoints3DVectors(2);
  scan.points3D_x = {1, 0};
  scan.points3D_y = {2, 0};
  scan.points3D_z = {3, 0};  // the second has no return
  expectMapPoints(scan, {{1, 5.5, 5}});
}

TEST(ObservationPoints, RangeCameraWithoutAnythingHasNoPoints)
{
  mrpt::obs::CObservation3DRangeScan scan;
  expectMapPoints(scan, {});
  scan.hasRangeImage = true;
  const auto got = sensorPoints(scan, {});
  ASSERT_TRUE(got);
  EXPECT_TRUE(got->points.empty());
}

TEST(ObservationPoints, ExternalRangeImageStaysOutside)
{
  const TempDir dir;
  mrpt::img::CImage::setImagesPathBase(dir.path());
  auto scan = rangeCamera(8);
  scan.hasIntensityImage = true;
  scan.intensityImage.setExternalStorage("missing.png");
  scan.rangeImage_convertToExternalStorage("range.bin", dir.path());
  ASSERT_EQ(scan.rangeImage.size(), 0);
  expectMapPoints(scan, {{0, 2.5, 5}, {1, 2.5, 1}});
  EXPECT_EQ(scan.rangeImage.size(), 0);
  EXPECT_TRUE(scan.intensityImage.isExternallyStored());
}

TEST(ObservationPoints, ExternalPointsStayOutside)
{
  const TempDir dir;
  mrpt::img::CImage::setImagesPathBase(dir.path());
  mrpt::obs::CObservation3DRangeScan scan;
  scan.sensorPose = sensorPose();
  scan.hasPoints3D = true;
  scan.resizePoints3DVectors(1);
  scan.points3D_x = {1};
  scan.points3D_y = {2};
  scan.points3D_z = {3};
  scan.points3D_convertToExternalStorage("points.bin", dir.path());
  ASSERT_TRUE(scan.points3D_x.empty());
  expectMapPoints(scan, {{1, 5.5, 5}});
  EXPECT_TRUE(scan.points3D_x.empty());
}

TEST(ObservationPoints, MissingExternalFileIsAnError)
{
  const TempDir dir;
  mrpt::img::CImage::setImagesPathBase(dir.path());
  auto scan = rangeCamera(8);
  scan.rangeImage_convertToExternalStorage("range.bin", dir.path());
  for (const auto& entry : std::filesystem::directory_iterator(dir.path()))
    std::filesystem::remove(entry.path());
  scan.sensorLabel = "KINECT";
  const std::string error = messageOf([&scan] { sensorPoints(scan, {}); });
  EXPECT_TRUE(contains(error, "'KINECT'") && contains(error, dir.path())) << error;
}

TEST(ObservationPoints, PointCloud)
{
  expectMapPoints(cloud({{1, 2, 3}, {0, 0, 0}, {-1, 0, 0}}), {{1, 5.5, 5}, {3, 2.5, 3}});
  mrpt::obs::CObservationPointCloud none;
  expectMapPoints(none, {});
}

TEST(ObservationPoints, ExternalPointCloudStaysOutside)
{
  const TempDir dir;
  mrpt::img::CImage::setImagesPathBase(dir.path());
  auto scan = cloud({{1, 2, 3}});
  scan.setAsExternalStorage(
      "cloud.bin", mrpt::obs::CObservationPointCloud::ExternalStorageFormat::MRPT_Serialization);
  scan.unload();
  ASSERT_FALSE(scan.pointcloud);
  expectMapPoints(scan, {{1, 5.5, 5}});
  EXPECT_FALSE(scan.pointcloud);
}

TEST(ObservationPoints, VelodynePackets)
{
  // Right of the sensor and 1° up; laser 3 is nearer than minRange.
  const double y = -5 * std::cos(M_PI / 180), z = 5 * std::sin(M_PI / 180);
  constexpr double tolerance = 1e-3;  // MRPT's table of sines is up to 0.0075° off
  auto scan = velodyne();
  expectMapPoints(scan, {{2, 2.5 + z, 3 + y}}, tolerance);
  EXPECT_EQ(scan.point_cloud.size(), 0u);
  // MRPT's own default would drop everything under a metre.
  scan.minRange = 0.1;
  const double y3 = -0.5 * std::cos(M_PI / 60), z3 = 0.5 * std::sin(M_PI / 60);
  expectMapPoints(scan, {{2, 2.5 + z, 3 + y}, {2, 2.5 + z3, 3 + y3}}, tolerance);
}

TEST(ObservationPoints, VelodyneWithoutCalibrationTakesTheShippedOne)
{
  auto scan = velodyne();
  scan.calibration.clear();
  const auto got = sensorPoints(scan, {});
  ASSERT_TRUE(got);
  EXPECT_EQ(got->points.size(), 1u);

  scan.scan_packets[0].velodyne_model_ID = 0x99;
  Warnings log;
  SayOnceLog warnings(&log);
  for (int i = 0; i < 3; ++i)
  {
    const auto none = sensorPoints(scan, {}, &warnings);
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->points.empty());
  }
  ASSERT_EQ(log.texts.size(), 1u);
  EXPECT_TRUE(contains(log.texts[0], "model 153"));
}

TEST(ObservationPoints, VelodynesOwnCloudComesFirst)
{
  auto scan = velodyne();
  scan.point_cloud.x = {1};
  scan.point_cloud.y = {2};
  scan.point_cloud.z = {3};
  scan.point_cloud.intensity = {0};
  expectMapPoints(scan, {{1, 5.5, 5}});
}

TEST(ObservationPoints, RotatingScan)
{
  mrpt::obs::CObservationRotatingScan scan;
  scan.sensorPose = sensorPose();
  scan.rowCount = 1;
  scan.columnCount = 3;
  scan.rangeResolution = 0.5;
  scan.startAzimuth = M_PI / 2;
  scan.azimuthSpan = -M_PI;
  scan.rangeImage.setZero(1, 3);
  scan.rangeImage(0, 0) = 2;  // 1 m to the left; nothing ahead
  scan.rangeImage(0, 2) = 6;  // 3 m to the right
  expectMapPoints(scan, {{2, 2.5, 4}, {2, 2.5, 0}});
}

TEST(ObservationPoints, TheAzimuthStepIsThatOfTheSensorsColumns)
{
  const auto stepOf = [](const mrpt::obs::CObservation& obs)
  {
    const auto got = sensorPoints(obs, {});
    return got ? got->azimuthStep : -1;
  };
  mrpt::obs::CObservationRotatingScan rotating;
  rotating.rangeResolution = 0.5;
  rotating.azimuthSpan = -M_PI;
  rotating.rangeImage.setConstant(1, 5, 4);
  EXPECT_NEAR(stepOf(rotating), M_PI / 4, 1e-12);
  rotating.rangeImage.setConstant(1, 1, 4);
  EXPECT_EQ(stepOf(rotating), 0);

  auto camera = rangeCamera(8);
  camera.cameraParams.setIntrinsicParamsFromValues(500, 400, 1, 0);
  EXPECT_NEAR(stepOf(camera), 1.0 / 500, 1e-12);
  camera.cameraParams.setIntrinsicParamsFromValues(0, 0, 0, 0);
  camera.hasPoints3D = true;
  camera.resizePoints3DVectors(1);
  EXPECT_EQ(stepOf(camera), 0);

  auto packets = velodyne();
  EXPECT_EQ(stepOf(packets), 0) << "it stands still";
  for (std::size_t block = 0; block < 12; ++block)  // each twice, over north, one step missing
  {
    const std::size_t turned = 35900 + 40 * (block / 2) + (block > 7 ? 40 : 0);
    put<std::uint16_t>(packets.scan_packets[0], 100 * block + 2,
                       static_cast<std::uint16_t>(turned % 36000));
  }
  EXPECT_NEAR(stepOf(packets), mrpt::DEG2RAD(0.4), 1e-12);

  EXPECT_EQ(stepOf(cloud({{1, 2, 3}})), 0);
  EXPECT_EQ(stepOf(scan2D()), 0);
}

TEST(ObservationPoints, AnObjectReadIntoAgainHoldsNothingOfTheFormerScan)
{
  SensorPoints scan;
  mrpt::obs::CObservationRotatingScan rotating;
  rotating.rangeResolution = 0.5;
  rotating.azimuthSpan = -M_PI;
  rotating.rangeImage.setConstant(1, 5, 4);
  ASSERT_TRUE(sensorPoints(rotating, {}, scan));
  EXPECT_EQ(scan.points.size(), 5u);
  ASSERT_TRUE(sensorPoints(cloud({{1, 2, 3}, {4, 5, 6}}), robotPose(), scan));
  EXPECT_EQ(scan.points, (std::vector<TPoint3Df>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(scan.azimuthStep, 0);
  EXPECT_EQ(scan.sensorPose, robotPose() + sensorPose());

  EXPECT_FALSE(sensorPoints(mrpt::obs::CObservationRange(), {}, scan));
  EXPECT_EQ(scan.points.size(), 2u) << "no scan leaves it as it was";
  ASSERT_TRUE(sensorPoints(mrpt::obs::CObservationPointCloud(), {}, scan));
  EXPECT_TRUE(scan.points.empty());
}

TEST(ObservationPoints, ASeriesOfPointCloudsNeedsNoMoreMemory)
{
  const auto large = cloud({{1, 2, 3}, {4, 5, 6}, {0, 0, 0}}), small = cloud({{1, 2, 3}});
  SensorPoints scan;
  SayOnceLog warnings;
  const auto readBoth = [&]
  {
    sensorPoints(large, robotPose(), scan, &warnings);
    sensorPoints(small, robotPose(), scan, &warnings);
  };
  EXPECT_GT(allocationsOf(readBoth), 0u) << "allocations are not counted";
  EXPECT_EQ(allocationsOf(readBoth), 0u);
}

TEST(ObservationPoints, UnknownModelIsNamedOnce)
{
  mrpt::obs::CObservationRotatingScan scan;
  scan.rowCount = 2;
  scan.columnCount = 3;
  scan.rangeResolution = 0.5;
  scan.rangeImage.setConstant(2, 3, 4);
  Warnings log;
  SayOnceLog warnings(&log);
  for (const char* model : {"OS1-64", "OS1-64", "Pandar", "OS1-64"})
  {
    scan.lidarModel = model;
    const auto got = sensorPoints(scan, {}, &warnings);
    ASSERT_TRUE(got);
    EXPECT_TRUE(got->points.empty());
  }
  ASSERT_EQ(log.texts.size(), 2u);
  EXPECT_TRUE(contains(log.texts[0], "'OS1-64'")) << log.texts[0];
  EXPECT_TRUE(contains(log.texts[1], "'Pandar'")) << log.texts[1];
}

TEST(ObservationPoints, DropsWhatIsNotFiniteAndSaysHowMuch)
{
  const float inf = std::numeric_limits<float>::infinity();
  auto scan = cloud({{1, 2, 3}, {kNaN, 0, 0}, {0, inf, 0}, {0, 0, -inf}});
  scan.sensorLabel = "LIDAR";
  Warnings log;
  SayOnceLog warnings(&log);
  const auto got = sensorPoints(scan, {}, &warnings);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->points, (std::vector<TPoint3Df>{{1, 2, 3}}));
  ASSERT_EQ(log.texts.size(), 1u);
  EXPECT_TRUE(contains(log.texts[0], "3 points")) << log.texts[0];
  EXPECT_TRUE(contains(log.texts[0], "'LIDAR'")) << log.texts[0];
}

TEST(ObservationPoints, OtherClassesAreNoScans)
{
  Warnings log;
  SayOnceLog warnings(&log);
  const mrpt::obs::CObservationRange sonar;
  EXPECT_FALSE(sensorPoints(sonar, robotPose(), &warnings));
  EXPECT_TRUE(log.texts.empty());
  EXPECT_FALSE(isScan(sonar));
  EXPECT_FALSE(is3DScan(sonar));
  EXPECT_TRUE(isScan(scan2D()));
  EXPECT_FALSE(is3DScan(scan2D()));
  EXPECT_TRUE(is3DScan(velodyne()));
}

}  // namespace mrpt_mapconv::observation
