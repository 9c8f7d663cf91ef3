// Where the scans of a rawlog were taken: sources of poses, gaps, times.
#include <limits>

#include "LogObjects.h"

namespace mrpt_mapconv::observation
{
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

}  // namespace mrpt_mapconv::observation
