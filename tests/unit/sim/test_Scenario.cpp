#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include "RoomFixtures.h"

using namespace mrpt_mapconv::sim::fixtures;
using mrpt_mapconv::sim::Scenario;
using mrpt_mapconv::testing::contains;
using mrpt_mapconv::testing::messageOf;

TEST(Scenario, ReadsWhatTheFileSays)
{
  const auto s = load(kRoom + kScanner + kLidar + kDrive + R"(
[noise]
odometryPerMetre = 0.02      // [m]
odometryYawPerMetre = 0.3
odometryYawPerTurn = 2
odometryDrift = -0.1
posePosition = 0.01
poseAngle = 0.2
[log]
poses = true
keyFrameEvery = 3
[truth]
resolution = 0.25
minClearance = 0.8
robotHeight = 0.7
maxSlope = 0.4
maxStep = 0.05
)");
  EXPECT_EQ(s.world.size(), 6u);
  ASSERT_EQ(s.sensors.size(), 2u);
  EXPECT_EQ(s.sensors[0]->params().name, "front");  // by name, not by place in the file
  EXPECT_EQ(s.sensors[1]->params().name, "lidar");
  EXPECT_EQ(s.sensors[1]->rays(), 16u * 90u);
  EXPECT_DOUBLE_EQ(s.trajectory.duration(), 10);
  EXPECT_EQ(s.noise.odometryPerMetre, 0.02);
  EXPECT_EQ(s.noise.odometryYawPerMetre, 0.3);
  EXPECT_EQ(s.noise.odometryYawPerTurn, 2);
  EXPECT_EQ(s.noise.odometryDrift, -0.1);
  EXPECT_EQ(s.noise.posePosition, 0.01);
  EXPECT_EQ(s.noise.poseAngle, 0.2);
  EXPECT_TRUE(s.log.poses);
  EXPECT_EQ(s.log.keyFrameEvery, 3);
  EXPECT_EQ(s.truthResolution, 0.25);
  EXPECT_EQ(s.truth.minClearance, 0.8);
  EXPECT_EQ(s.truth.robotHeight, 0.7);
  EXPECT_EQ(s.truth.maxSlope, 0.4);
  EXPECT_EQ(s.truth.maxStep, 0.05);
}

TEST(Scenario, NoiseLogAndTruthMayBeLeftOut)
{
  const auto s = load(kRoom + kScanner + kDrive);
  EXPECT_EQ(s.noise.odometryPerMetre, 0);
  EXPECT_FALSE(s.log.poses);
  EXPECT_EQ(s.log.keyFrameEvery, 1);
  EXPECT_EQ(s.truthResolution, 0.1);
}

TEST(Scenario, NamesWhatIsWrong)
{
  const std::string good = kRoom + kScanner + kDrive;
  const auto drive = [](const std::string& keys)
  { return kRoom + kScanner + "[trajectory]\nspeed = 1\n" + keys; };
  const std::vector<std::pair<std::string, std::string>> bad{
      {kRoom + kDrive, "there is no sensor"},
      {kRoom + kScanner, "there is no trajectory"},
      {kScanner + kDrive, "section 'world'"},
      {good + "[pyramid.p]\nbase = 3\n", "section 'pyramid.p': 'pyramid' is not a kind"},
      {good + "[nois]\ndrift = 3\n", "section 'nois'"},
      {good + "[box.table]\nmin = 1 1 1\nmax = 0 2 2\n", "section 'box.table'"},
      {good + "[sensor.]\nkind = lidar\n", "section 'sensor.' must have a name"},
      {good + "[sensor.x]\nkind = lidar\nrate = -1\n", "section 'sensor.x': rate = '-1'"},
      {good + "[noise]\nodometryPerMetre = -0.1\n",
       "section 'noise': odometryPerMetre = '-0.1' "
       "is not valid: it must be a number >= 0"},
      {good + "[noise]\ndrift = 1\n", "section 'noise': 'drift' is not a key"},
      {good + "[log]\nkeyFrameEvery = 0\n", "section 'log': keyFrameEvery = '0'"},
      {good + "[log]\nposes = maybe\n", "section 'log': poses = 'maybe'"},
      {good + "[truth]\nresolution = 0\n", "section 'truth': resolution = '0'"},
      {good + "[truth]\nminClearance = -1\n", "section 'truth': minClearance"},
      {good + "just some words\n", "'just some words' is no section, comment or key = value"},
      {drive("waypoints = [0 0 0] [5.2 0 0]"),
       "section 'trajectory': waypoints: the way from number 1 to 2, at (4.9, 0, 0), puts sensor "
       "'front' inside 'box.east'; it must be in free space"},
      {drive("waypoints = [5.2 0 0] [0 0 0]"),
       "waypoints: number 1 at (5.2, 0, 0) puts the robot inside 'box.east'"},
      {drive("waypoints = [0 0 0] [9 0 0]"), "inside 'box.east'"},
      {drive("waypoints = [7 0 0] [8 0 0]"),
       "number 1 at (7, 0, 0) puts the robot at (7, 0, 0.01), but it must be within the bounds "
       "(-6, -6, -1) to (6, 6, 3.1)"},
      {kRoom + kScanner +
           "[trajectory]\nposes = [0 0 0 0 0 0 0] [1 0 0 0 180 0 0] [2 4.95 0 0 0 "
           "0 0]\n",
       "poses: number 3 at (4.95, 0, 0) puts sensor 'front' inside 'box.east'"},
  };
  for (const auto& [text, part] : bad)
  {
    const TempDir dir;
    const std::string file = dir.path("bad.ini");
    std::ofstream(file) << text;
    const auto message = messageOf([&] { Scenario::load(file); });
    EXPECT_EQ(message.rfind(file + ": ", 0), 0u) << message;
    EXPECT_TRUE(contains(message, part)) << message << "\nis not about: " << part;
    EXPECT_FALSE(contains(message, "\n")) << message;
  }
}

TEST(Scenario, NamesAFileThatCannotBeRead)
{
  const TempDir dir;
  for (const auto& file : {dir.path("none.ini"), dir.path()})
    EXPECT_TRUE(contains(messageOf([&, f = file] { Scenario::load(f); }), file)) << file;
}

TEST(Scenario, WorldsOfTheRepositoryAreGood)
{
  const std::string worlds = MRPT_MAPCONV_SOURCE_DIR "/config/worlds/";
  for (const char* name : {"building", "cave", "outdoor"})
  {
    const auto s = Scenario::load(worlds + name + ".ini");
    EXPECT_EQ(s.trajectory.isFlat(), std::string(name) == "building");
    EXPECT_EQ(s.log.poses, std::string(name) != "building");
  }
}
