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
poseHeight = 0.003
poseTilt = 0.05
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
  EXPECT_EQ(s.noise.poseHeight, 0.003);
  EXPECT_EQ(s.noise.poseTilt, 0.05);
  EXPECT_TRUE(s.log.poses);
  EXPECT_EQ(s.log.keyFrameEvery, 3);
  EXPECT_EQ(s.truthResolution, 0.25);
  EXPECT_EQ(s.truth.minClearance, 0.8);
  EXPECT_EQ(s.truth.robotHeight, 0.7);
  EXPECT_EQ(s.truth.maxSlope, 0.4);
  EXPECT_EQ(s.truth.maxStep, 0.05);
}

TEST(Scenario, HasTheSensorsThatAreNotSpareOrThoseThatAreAskedFor)
{
  const TempDir dir;
  const std::string file = dir.path("world.ini");
  const auto namesOf = [&](const std::vector<std::string>& wanted)
  {
    std::string names;
    for (const auto& sensor : Scenario::load(file, wanted).sensors)
      names += sensor->params().name + " ";
    return names;
  };
  std::ofstream(file) << kRoom + kScanner + "spare = true\n" + kLidar + kCamera + kDrive;
  EXPECT_EQ(namesOf({}), "camera lidar ");
  EXPECT_EQ(namesOf({"front"}), "front ");
  EXPECT_EQ(namesOf({"lidar", "front"}), "front lidar ");
  EXPECT_EQ(messageOf(
                [&] {
                  namesOf({"lidar", "rear"});
                }),
            file + ": there is no sensor 'rear'; it must be one of 'camera' 'front' 'lidar'");

  std::ofstream(file) << kRoom + kScanner + "spare = true\n" + kDrive;
  EXPECT_EQ(messageOf([&] { namesOf({}); }),
            file + ": all sensors are spare: one must be asked for by its name");
  EXPECT_EQ(namesOf({"front"}), "front ");
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
  const auto withBounds = [&](const std::string& bounds)
  {
    std::string text = good;
    const std::string before = "-6 -6 -1  6 6 3.1";
    return text.replace(text.find(before), before.size(), bounds);
  };
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
      {good + "[noise]\nposeHeight = -1\n", "section 'noise': poseHeight = '-1'"},
      {good + "[noise]\nposeTilt = -1\n", "section 'noise': poseTilt = '-1'"},
      {good + "[noise]\ndrift = 1\n", "section 'noise': 'drift' is not a key"},
      {good + "[log]\nkeyFrameEvery = 0\n", "section 'log': keyFrameEvery = '0'"},
      {good + "[log]\nposes = maybe\n", "section 'log': poses = 'maybe'"},
      {good + "[truth]\nresolution = 0\n", "section 'truth': resolution = '0'"},
      {good + "[truth]\nminClearance = -1\n", "section 'truth': minClearance"},
      {good + "[truth]\nresolution = 0.0001\n",
       "section 'truth': resolution = '0.0001' is not valid: it must be so large that the truth "
       "has at most 4e7 cells, 1e5 on a side"},
      {good + "[truth]\nresolution = 1e-300\n", "section 'truth': resolution = '1e-300'"},
      {withBounds("-1e6 -1e6 -1  1e6 1e6 3"),
       "section 'world': bounds = (-1e+06, -1e+06, -1) to (1e+06, 1e+06, 3) is not valid"},
      {withBounds("-1e6 -6 -1  1e6 6 3"), "section 'world': bounds"},
      {"[world]\nbounds = 0 0 0 1 1 1\n" + kScanner + kDrive,
       "section 'world': there is no body in it: a section 'KIND.NAME' must be there"},
      {good + "[box.far]\nmin = 7 0 0\nmax = 8 1 1\n",
       "section 'box.far': the body is outside the world's bounds (-6, -6, -1) to (6, 6, 3.1)"},
      {good + "[box.north2]\nmin = 0 7 0\nmax = 1 8 1\n", "section 'box.north2': the body is"},
      {good + "[sphere.moon]\ncentre = 0 0 9\nradius = 5\n", "section 'sphere.moon': the body is"},
      {good + "[cylinder.pit]\nbase = 0 0 -9\nradius = 1\nheight = 7\n",
       "section 'cylinder.pit': the body is outside"},
      {kRoom + kScanner + "dropout = 1\n" + kDrive, "section 'sensor.front': dropout = '1'"},
      {kRoom + kScanner + "spare = perhaps\n" + kDrive,
       "section 'sensor.front': spare = 'perhaps'"},
      {kRoom + kScanner + "[trajectory]\nspeed = 1e-9\nwaypoints = [0 0 0] [1 0 0]",
       "section 'trajectory': speed = '1e-9' is not valid: it must be such that the run takes at "
       "most 86400 s (24 h)"},
      {drive("turnRate = 0.001\nwaypoints = [0 0 0] [1 0 0] [1 1 0]"),
       "section 'trajectory': turnRate = '0.001' is not valid"},
      {kRoom + kScanner + "[trajectory]\nposes = [0 0 0 0 0 0 0] [86401 1 0 0 0 0 0]\n",
       "section 'trajectory': poses = '[0 0 0 0 0 0 0] [86401 1 0 0 0 0 0]' is not valid"},
      {good + "[box.floor]\nmin = 0 0 0\nmax = 1 1 1\n", "section 'box.floor' is already in line"},
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

TEST(Scenario, LimitsAreJustAllowed)
{
  const auto day =
      load(kRoom + kScanner + "[trajectory]\nposes = [0 0 0 0 0 0 0] [86400 1 0 0 0 0 0]\n");
  EXPECT_EQ(day.trajectory.duration(), 86400);
  // bodies that reach into the bounds from beyond, or touch them from there: good walls for rays
  const auto touching = load(kRoom +
                             "[box.sky]\nmin = 0 0 3.1\nmax = 20 20 4\n"
                             "[box.aside]\nmin = 6 0 0\nmax = 9 1 1\n" +
                             kScanner + kDrive);
  EXPECT_EQ(touching.world.size(), 8u);
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
  for (const char* name : {"building", "cave", "drops", "outdoor"})
  {
    const auto s = Scenario::load(worlds + name + ".ini");
    EXPECT_EQ(s.trajectory.isFlat(), std::string(name) == "building");
    EXPECT_EQ(s.log.poses, std::string(name) != "building");
  }
}
