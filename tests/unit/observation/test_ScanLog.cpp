// What rawlogs and simplemaps hold, and what is wrong with those that are refused.
#include <mrpt/img/CImage.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>

#include <limits>

#include "LogObjects.h"

namespace mrpt_mapconv::observation
{
TEST(Rawlog, OneScanNeedsNoPose)
{
  const TempDir dir;
  const Warnings log;
  const auto scans = readRawlog(rawlog(dir, {cloudAt(0), scan2DAt(0)}), {}, &log);
  ASSERT_EQ(scans.size(), 1u);
  expectPose(scans[0].robotPose, 0, 0, 0, 0);
  EXPECT_EQ(log.texts.size(), 1u);
}

TEST(Rawlog, SeveralScansNeedPosesUnlessStatic)
{
  const TempDir dir;
  const auto path = rawlog(dir, {cloudAt(0), cloudAt(1)});
  EXPECT_TRUE(contains(rawlogError(path), "2 scans but no robot poses")) << rawlogError(path);
  EXPECT_EQ(readRawlog(path, {true}).size(), 2u);
}

TEST(Rawlog, StaticOverridesPoses)
{
  const TempDir dir;
  const auto path = rawlog(dir, {poseAt(0, {1, 2, 3, 0, 0, 0}), cloudAt(0), cloudAt(100)});
  const auto scans = readRawlog(path, {true});
  ASSERT_EQ(scans.size(), 2u);
  for (const auto& scan : scans) expectPose(scan.robotPose, 0, 0, 0, 0);
}

TEST(Rawlog, ScansIn2DAreTakenAsThoseOfASimplemapAre)
{
  const TempDir dir;
  const auto moving = rawlog(dir, {poseAt(0, {1, 2, 0, 0, 0, 0}), scan2DAt(0), scan2DAt(5)});
  const auto scans = readRawlog(moving);
  ASSERT_EQ(scans.size(), 1u) << "no pose is known at 5 s";
  expectPose(scans[0].robotPose, 1, 2, 0, 0);
  EXPECT_EQ(readRawlog(rawlog(dir, {scan2DAt(0)})).size(), 1u) << "a single scan needs no pose";
  const auto lost = rawlog(dir, {scan2DAt(0), scan2DAt(1)});
  EXPECT_TRUE(contains(rawlogError(lost), "2 scans but no robot poses")) << rawlogError(lost);
  const auto outside = rawlog(dir, {poseAt(0, {}), scan2DAt(5)});
  EXPECT_TRUE(contains(rawlogError(outside), "no 2D scan lies within the time span"))
      << rawlogError(outside);
  EXPECT_GT(readRawlog(std::string(kMrptData) + "localization_demo.rawlog").size(), 30u);
}

TEST(Rawlog, WithoutScans)
{
  const TempDir dir;
  const auto path = rawlog(dir, {poseAt(0, {})});
  EXPECT_EQ(rawlogError(path).rfind(path + ": no scans (", 0), 0u) << rawlogError(path);
  const std::string real = std::string(kMrptData) + "kf-slam_demo.rawlog";
  EXPECT_TRUE(contains(rawlogError(real), "no scans (")) << rawlogError(real);
}

TEST(Rawlog, WholeRawlogAsOneObject)
{
  const TempDir dir;
  auto inner = mrpt::obs::CRawlog::Create();
  inner->insert(cloudAt(0));
  EXPECT_EQ(readRawlog(rawlog(dir, {inner})).size(), 1u);
}

TEST(Rawlog, TruncatedIsAnErrorAndNotHalfTheData)
{
  const TempDir dir;
  const auto path = rawlog(dir, {poseAt(0, {}), cloudAt(0), cloudAt(0), cloudAt(0)});
  const std::string whole = readBytes(path);
  for (const std::size_t lost : {std::size_t{1}, std::size_t{9}, whole.size() / 2})
  {
    writeBytes(path, whole.substr(0, whole.size() - lost));
    EXPECT_TRUE(contains(rawlogError(path), "truncated")) << rawlogError(path);
  }
}

TEST(Rawlog, ForeignFiles)
{
  const TempDir dir;
  EXPECT_TRUE(contains(rawlogError(dir.file("none.rawlog")), "no such file"));
  writeBytes(dir.file("a.rawlog"), "hello");
  EXPECT_TRUE(contains(rawlogError(dir.file("a.rawlog")), "no file of MRPT objects"));
  const std::string map = std::string(kMrptData) + "localization_demo.simplemap.gz";
  EXPECT_TRUE(contains(rawlogError(map), "CSimpleMap")) << rawlogError(map);
}

TEST(Rawlog, FindsImagesBesideTheLog)
{
  const TempDir dir;
  std::filesystem::create_directory(dir.file("test_Images"));
  auto scan = mrpt::obs::CObservation3DRangeScan::Create();
  scan->timestamp = at(0);
  scan->hasRangeImage = true;
  scan->rangeImage.setConstant(1, 1, 2000);
  scan->cameraParams.ncols = scan->cameraParams.nrows = 1;
  scan->cameraParams.setIntrinsicParamsFromValues(1, 1, 0, 0);
  scan->rangeImage_convertToExternalStorage("range.bin", dir.file("test_Images"));
  const auto path = rawlog(dir, {scan});
  mrpt::img::CImage::setImagesPathBase("/nowhere");
  const auto scans = readRawlog(path);
  ASSERT_EQ(scans.size(), 1u);
  const auto got = sensorPoints(*scans[0].observation, scans[0].robotPose);
  ASSERT_TRUE(got);
  ASSERT_EQ(got->points.size(), 1u);
  EXPECT_EQ(got->points[0], mrpt::math::TPoint3Df(2, 0, 0));
}

namespace
{
std::string simpleMap(const TempDir& dir, const std::vector<CPose3D>& poses)
{
  mrpt::maps::CSimpleMap map;
  for (const auto& pose : poses)
    map.insert(mrpt::poses::CPose3DPDFGaussian(pose),
               *frame({cloudAt(0), mrpt::obs::CObservationRange::Create(), scan2DAt(0)}));
  const std::string path = dir.file("test.simplemap");
  EXPECT_TRUE(map.saveToFile(path));
  return path;
}
}  // namespace

TEST(SimpleMap, EveryScanOfEveryKeyframe)
{
  const TempDir dir;
  const auto path = simpleMap(dir, {{1, 2, 3, 0, 0, 0}, {4, 5, 6, mrpt::DEG2RAD(90.0), 0, 0}});
  const auto scans = readSimpleMap(path);
  ASSERT_EQ(scans.size(), 4u);
  expectPose(scans[0].robotPose, 1, 2, 3, 0);
  expectPose(scans[1].robotPose, 1, 2, 3, 0);
  expectPose(scans[3].robotPose, 4, 5, 6, 90);
}

TEST(SimpleMap, KeyframesWithoutFinitePoseAreCounted)
{
  const TempDir dir;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto path = simpleMap(dir, {{1, 2, 3, 0, 0, 0}, {nan, 0, 0, 0, 0, 0}});
  const Warnings log;
  EXPECT_EQ(readSimpleMap(path, &log).size(), 2u);
  ASSERT_EQ(log.texts.size(), 1u);
  EXPECT_TRUE(contains(log.texts[0], "1 of 2 keyframes left out")) << log.texts[0];
}

TEST(SimpleMap, BadFiles)
{
  const TempDir dir;
  EXPECT_TRUE(contains(simpleMapError(dir.file("none")), "no such file"));
  const auto path = simpleMap(dir, {{}});
  const std::string whole = readBytes(path);
  for (const std::size_t lost : {std::size_t{1}, whole.size() / 2})
  {
    writeBytes(path, whole.substr(0, whole.size() - lost));
    EXPECT_TRUE(contains(simpleMapError(path), "truncated")) << simpleMapError(path);
  }
  EXPECT_TRUE(contains(simpleMapError(simpleMap(dir, {})), "no scans"));
  const auto log = rawlog(dir, {cloudAt(0)});
  EXPECT_TRUE(
      contains(simpleMapError(log), "no simplemap, but a mrpt::obs::CObservationPointCloud"));
}

}  // namespace mrpt_mapconv::observation
