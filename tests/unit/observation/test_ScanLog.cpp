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

namespace mrpt_mapconv::observation
{
using namespace fixtures;
using mrpt::obs::CObservation;
using mrpt::obs::CObservationPointCloud;
using mrpt::poses::CPose3D;

namespace
{
mrpt::system::TTimeStamp at(double seconds) { return mrpt::Clock::fromDouble(1e9 + seconds); }

CObservation::Ptr cloudAt(double seconds)
{
  auto scan = CObservationPointCloud::Create();
  scan->timestamp = at(seconds);
  scan->pointcloud = mrpt::maps::CSimplePointsMap::Create();
  scan->pointcloud->insertPoint(1, 2, 3);
  return scan;
}

CObservation::Ptr scan2DAt(double seconds)
{
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->timestamp = at(seconds);
  return scan;
}

CObservation::Ptr poseAt(double seconds, const CPose3D& pose, const std::string& label = "")
{
  auto obs = mrpt::obs::CObservationRobotPose::Create();
  obs->timestamp = at(seconds);
  obs->sensorLabel = label;
  obs->pose.mean = pose;
  return obs;
}

CObservation::Ptr odometryAt(double seconds, double x, double y, double yawDegrees,
                             const std::string& label = "")
{
  auto obs = mrpt::obs::CObservationOdometry::Create();
  obs->timestamp = at(seconds);
  obs->sensorLabel = label;
  obs->odometry = {x, y, mrpt::DEG2RAD(yawDegrees)};
  return obs;
}

CObservation::Ptr withoutTime(const CObservation::Ptr& obs)
{
  obs->timestamp = INVALID_TIMESTAMP;
  return obs;
}

/** Writes a rawlog of these objects. */
std::string rawlog(const TempDir& dir,
                   const std::vector<mrpt::serialization::CSerializable::Ptr>& o)
{
  mrpt::obs::CRawlog log;
  for (const auto& object : o) log.insert(object);
  const std::string path = dir.file("test.rawlog");
  EXPECT_TRUE(log.saveToRawLogFile(path));
  return path;
}

mrpt::obs::CSensoryFrame::Ptr frame(const std::vector<CObservation::Ptr>& observations)
{
  auto out = mrpt::obs::CSensoryFrame::Create();
  for (const auto& obs : observations) out->insert(obs);
  return out;
}

mrpt::obs::CActionCollection::Ptr wheelStep(double x, double y, double yawDegrees)
{
  mrpt::obs::CActionRobotMovement2D move;
  mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmThrun;  // draws at random
  move.computeFromOdometry({x, y, mrpt::DEG2RAD(yawDegrees)}, model);
  auto out = mrpt::obs::CActionCollection::Create();
  out->insert(move);
  return out;
}

void expectPose(const CPose3D& got, double x, double y, double z, double yawDegrees)
{
  EXPECT_NEAR(got.x(), x, 1e-6) << got;
  EXPECT_NEAR(got.y(), y, 1e-6) << got;
  EXPECT_NEAR(got.z(), z, 1e-6) << got;
  EXPECT_NEAR(got.yaw(), mrpt::DEG2RAD(yawDegrees), 1e-6) << got;
}

std::string rawlogError(const std::string& path)
{
  return messageOf([&path] { readRawlog(path); });
}
std::string simpleMapError(const std::string& path)
{
  return messageOf([&path] { readSimpleMap(path); });
}
}  // namespace

TEST(Rawlog, RobotPosesComeBeforeOdometry)
{
  const TempDir dir;
  const auto path =
      rawlog(dir, {poseAt(0, {1, 2, 3, 0, 0, 0}), odometryAt(0, 50, 0, 0), cloudAt(0.25),
                   scan2DAt(0.5), mrpt::obs::CObservationRange::Create(),
                   poseAt(1, {5, 2, 3, mrpt::DEG2RAD(90.0), 0, 0}), odometryAt(1, 60, 0, 0)});
  const auto scans = readRawlog(path);
  ASSERT_EQ(scans.size(), 2u);
  expectPose(scans[0].robotPose, 2, 2, 3, 22.5);
  expectPose(scans[1].robotPose, 3, 2, 3, 45);
  EXPECT_TRUE(is3DScan(*scans[0].observation));
  EXPECT_FALSE(is3DScan(*scans[1].observation));
}

TEST(Rawlog, Odometry)
{
  const TempDir dir;
  // The poses may come after the scan.
  const auto path = rawlog(dir, {cloudAt(1.5), odometryAt(1, 0, 0, 0), odometryAt(2, 2, 4, 90)});
  const auto scans = readRawlog(path);
  ASSERT_EQ(scans.size(), 1u);
  expectPose(scans[0].robotPose, 1, 2, 0, 45);
}

TEST(Rawlog, WheelIncrementsAddUp)
{
  const TempDir dir;
  const auto path = rawlog(dir, {frame({cloudAt(0)}), wheelStep(1, 0, 90), frame({cloudAt(1)}),
                                 wheelStep(2, 0, 0), frame({cloudAt(2), scan2DAt(2)})});
  const auto scans = readRawlog(path);
  ASSERT_EQ(scans.size(), 4u);
  expectPose(scans[0].robotPose, 0, 0, 0, 0);
  expectPose(scans[1].robotPose, 1, 0, 0, 90);
  expectPose(scans[2].robotPose, 1, 2, 0, 90);
  expectPose(scans[3].robotPose, 1, 2, 0, 90);
}

TEST(Rawlog, IncrementsIn3D)
{
  const TempDir dir;
  mrpt::obs::CActionRobotMovement3D move;
  move.estimationMethod = mrpt::obs::CActionRobotMovement3D::emVisualOdometry;
  move.poseChange.mean = {1, 2, 3, 0, 0, 0};
  const auto actions = mrpt::obs::CActionCollection::Create();
  actions->insert(move);
  const auto scans = readRawlog(rawlog(dir, {actions, actions, frame({cloudAt(0)})}));
  ASSERT_EQ(scans.size(), 1u);
  expectPose(scans[0].robotPose, 2, 4, 6, 0);
}

TEST(Rawlog, RobotPosesInSensoryFrames)
{
  const TempDir dir;
  const auto path = rawlog(dir, {wheelStep(9, 0, 0), frame({poseAt(0, {}), cloudAt(0.5)}),
                                 frame({poseAt(1, {2, 0, 0, 0, 0, 0})})});
  const auto scans = readRawlog(path);
  ASSERT_EQ(scans.size(), 1u);
  expectPose(scans[0].robotPose, 1, 0, 0, 0);
}

TEST(Rawlog, OfSeveralSourcesTheRichestIsUsed)
{
  const TempDir dir;
  const auto path = rawlog(dir, {poseAt(0, {100, 0, 0, 0, 0, 0}, "gps"), poseAt(0, {}, "slam"),
                                 cloudAt(0.5), poseAt(1, {2, 0, 0, 0, 0, 0}, "slam")});
  const Warnings log;
  const auto scans = readRawlog(path, {}, &log);
  ASSERT_EQ(scans.size(), 1u);
  expectPose(scans[0].robotPose, 1, 0, 0, 0);
  ASSERT_EQ(log.texts.size(), 1u);
  EXPECT_TRUE(contains(log.texts[0], "'slam'")) << log.texts[0];
}

TEST(Rawlog, ScansOutsideThePosesAreCounted)
{
  const TempDir dir;
  const auto path = rawlog(dir, {cloudAt(-5), cloudAt(-0.05), poseAt(0, {}), cloudAt(0.5),
                                 poseAt(1, {1, 0, 0, 0, 0, 0}), cloudAt(1.05), cloudAt(9)});
  const Warnings log;
  const auto scans = readRawlog(path, {}, &log);
  ASSERT_EQ(scans.size(), 3u);
  expectPose(scans[0].robotPose, 0, 0, 0, 0);
  expectPose(scans[1].robotPose, 0.5, 0, 0, 0);
  expectPose(scans[2].robotPose, 1, 0, 0, 0);
  ASSERT_EQ(log.texts.size(), 1u);
  EXPECT_TRUE(contains(log.texts[0], "2 of 5 scans")) << log.texts[0];
}

TEST(Rawlog, ScansInGapsOfThePosesAreCountedWithTheLongestGap)
{
  const TempDir dir;
  auto stampless = cloudAt(0);
  stampless->timestamp = INVALID_TIMESTAMP;
  for (const bool odometry : {false, true})
  {
    const auto pose = [&](double seconds, double x) {
      return odometry ? odometryAt(seconds, x, 0, 0) : poseAt(seconds, {x, 0, 0, 0, 0, 0});
    };
    const auto path =
        rawlog(dir, {pose(0, 0), cloudAt(0.5), pose(1, 1), cloudAt(3), cloudAt(20), cloudAt(30.5),
                     pose(31, 2), cloudAt(33), pose(35, 3), cloudAt(40), stampless});
    const Warnings log;
    const auto scans = readRawlog(path, {}, &log);
    ASSERT_EQ(1u, scans.size());
    expectPose(scans[0].robotPose, 0.5, 0, 0, 0);
    ASSERT_EQ(1u, log.texts.size());
    for (const char* words : {"6 of 7 scans", "4 in gaps", "30.0 s", "1 outside",
                              "1 without a time", "within 1 s of it (--max-pose-gap"})
      EXPECT_TRUE(contains(log.texts[0], words)) << log.texts[0];
    RawlogOptions patient;
    patient.maxPoseGap = 60;
    EXPECT_EQ(5u, readRawlog(path, patient).size());
  }
}

TEST(Rawlog, TheSensorsPoseIsTakenOffARobotPose)
{
  const TempDir dir;
  auto pose = mrpt::obs::CObservationRobotPose::Create();
  pose->timestamp = at(0);
  pose->pose.mean = CPose3D(2, 3, 0.4, mrpt::DEG2RAD(90.0), 0, 0);  // of what stands on the robot
  pose->sensorPose = CPose3D(0.5, 0, 0.4, mrpt::DEG2RAD(90.0), 0, 0);
  const auto scans = readRawlog(rawlog(dir, {pose, cloudAt(0)}));
  ASSERT_EQ(1u, scans.size());
  expectPose(scans[0].robotPose, 1.5, 3, 0, 0);  // 0.5 m behind it along x, not turned
}

TEST(Rawlog, TheSourceOfThePosesCanBeChosen)
{
  const TempDir dir;
  const auto path =
      rawlog(dir, {poseAt(0, {1, 0, 0, 0, 0, 0}, "slam"), poseAt(0.5, {1, 0, 0, 0, 0, 0}, "slam"),
                   poseAt(0, {2, 0, 0, 0, 0, 0}, "gps"), odometryAt(0, 3, 0, 0), cloudAt(0)});
  const Warnings log;
  expectPose(readRawlog(path, {}, &log).at(0).robotPose, 1, 0, 0, 0);
  ASSERT_EQ(1u, log.texts.size());
  for (const char* words :
       {"'slam' (2)", "'gps' (1)", "'odometry' (1)", "those of 'slam'", "--pose-source"})
    EXPECT_TRUE(contains(log.texts[0], words)) << log.texts[0];

  RawlogOptions options;
  options.poseSource = "gps";
  const Warnings silent;
  expectPose(readRawlog(path, options, &silent).at(0).robotPose, 2, 0, 0, 0);
  EXPECT_TRUE(silent.texts.empty());
  options.poseSource = "lidar";
  try
  {
    readRawlog(path, options);
    ADD_FAILURE() << "read";
  }
  catch (const std::runtime_error& error)
  {
    for (const std::string& words : {path, std::string("'lidar'"), std::string("'gps' (1)")})
      EXPECT_TRUE(contains(error.what(), words)) << error.what();
  }
}

TEST(Rawlog, EverySourceOfPosesCanBeChosen)
{
  const TempDir dir;
  const auto x = [](double position) { return CPose3D(position, 0, 0, 0, 0, 0); };
  const auto path = rawlog(
      dir,
      {wheelStep(7, 0, 0), frame({poseAt(0, x(1)), poseAt(0, x(2), "base"), odometryAt(0, 3, 0, 0),
                                  odometryAt(0, 4, 0, 0, "base"), cloudAt(0)})});
  const std::vector<std::pair<std::string, double>> choices = {
      {"", 1},         {"robotPose", 1},     {"base", 2},      {"robotPose:base", 2},
      {"odometry", 3}, {"odometry:base", 4}, {"increments", 7}};
  for (const auto& [source, position] : choices)
  {
    RawlogOptions options;
    options.poseSource = source;
    const Warnings silent;
    expectPose(readRawlog(path, options, &silent).at(0).robotPose, position, 0, 0, 0);
    EXPECT_TRUE(silent.texts.empty()) << silent.texts.front();
  }
  const Warnings log;
  expectPose(readRawlog(path, {}, &log).at(0).robotPose, 1, 0, 0, 0);
  ASSERT_EQ(1u, log.texts.size());
  EXPECT_TRUE(contains(log.texts[0],
                       "'robotPose' (1), 'robotPose:base' (1), 'odometry' (1), 'odometry:base' "
                       "(1), 'increments' (1); those of 'robotPose' are used"))
      << log.texts[0];
}

TEST(Rawlog, NoScanWithinThePosesIsAnError)
{
  const TempDir dir;
  const auto path = rawlog(dir, {poseAt(0, {}), cloudAt(5), scan2DAt(0)});
  const Warnings log;
  const auto message = messageOf([&] { readRawlog(path, {}, &log); });
  for (const char* words : {"no 3D scan lies within the time span of the poses",
                            "within 1 s of both poses around it (--max-pose-gap)", ": 1 outside"})
    EXPECT_TRUE(contains(message, words)) << message;
  EXPECT_TRUE(log.texts.empty()) << "the error says it all";
}

TEST(Rawlog, ScansOrPosesWithoutATimeAreCalledThat)
{
  const TempDir dir;
  const auto stampless = [] { return withoutTime(cloudAt(0)); };
  const std::string hint = " (if the sensor stood still, say so: --static)";
  auto path = rawlog(dir, {poseAt(0, {}), stampless(), stampless()});
  EXPECT_EQ(path + ": all 2 scans have no time stamp" + hint, rawlogError(path));
  path = rawlog(dir, {poseAt(0, {}), stampless()});
  EXPECT_EQ(path + ": its scan has no time stamp" + hint, rawlogError(path));
  path = rawlog(dir, {poseAt(0, {}), stampless(), stampless(), scan2DAt(0)});
  EXPECT_EQ(path + ": all 2 3D scans have no time stamp" + hint, rawlogError(path));
  path =
      rawlog(dir, {withoutTime(poseAt(0, {})), withoutTime(poseAt(0, {})), cloudAt(0), cloudAt(1)});
  EXPECT_EQ(path + ": 2 scans but no pose that is of use, only 2 poses without a time stamp" + hint,
            rawlogError(path));
}

TEST(Rawlog, PosesThatAreNoneAreCounted)
{
  const TempDir dir;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto path = rawlog(dir, {poseAt(0, {}), poseAt(0.5, {nan, 0, 0, 0, 0, 0}), cloudAt(0.5),
                                 poseAt(1, {1, 0, 0, 0, 0, 0})});
  const Warnings log;
  const auto scans = readRawlog(path, {}, &log);
  ASSERT_EQ(scans.size(), 1u);
  expectPose(scans[0].robotPose, 0.5, 0, 0, 0);
  ASSERT_EQ(log.texts.size(), 1u);
  EXPECT_EQ("poses are left out: 1 pose with NaN or infinite coordinates", log.texts[0]);
}

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
