#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/sim/Trajectory.h>

#include "RoomFixtures.h"

using mrpt::DEG2RAD;
using mrpt::config::CConfigFileMemory;
using mrpt_mapconv::params::StrictSection;
using mrpt_mapconv::sim::Trajectory;
using mrpt_mapconv::sim::World;
using mrpt_mapconv::testing::contains;
using mrpt_mapconv::testing::messageOf;

namespace
{
const World kNothing({-10, -10, -1}, {10, 10, 5});

Trajectory read(const std::string& keys, const World& world = kNothing)
{
  const CConfigFileMemory ini("[trajectory]\n" + keys);
  StrictSection section(ini, "trajectory");
  return Trajectory::read(section, world);
}

World worldOf(const std::string& bodies)
{
  return World::fromIni(CConfigFileMemory("[world]\nbounds = -10 -10 -1  10 10 5\n" + bodies), {});
}

void expectPose(const Trajectory& t, double time, double x, double y, double z, double yawDegrees)
{
  const auto pose = t.poseAt(time);
  EXPECT_NEAR(pose.x(), x, 1e-12) << "at " << time << " s";
  EXPECT_NEAR(pose.y(), y, 1e-12) << "at " << time << " s";
  EXPECT_NEAR(pose.z(), z, 1e-12) << "at " << time << " s";
  // 180° and −180° are the same
  EXPECT_NEAR(std::cos(pose.yaw() - DEG2RAD(yawDegrees)), 1, 1e-12) << "at " << time << " s";
}
}  // namespace

// 2 m at 0.5 m/s, a quarter turn at 45°/s, 2 m again: 4 + 2 + 4 s
TEST(Trajectory, DrivesStraightAndTurnsOnTheSpot)
{
  const auto t = read("waypoints = [0 0 0] [2 0 0] [2 2 0]\nspeed = 0.5\nturnRate = 45");
  EXPECT_DOUBLE_EQ(t.duration(), 10);
  EXPECT_TRUE(t.isFlat());
  expectPose(t, 0, 0, 0, 0, 0);
  expectPose(t, 2, 1, 0, 0, 0);
  expectPose(t, 4, 2, 0, 0, 0);
  expectPose(t, 5, 2, 0, 0, 45);
  expectPose(t, 6, 2, 0, 0, 90);
  expectPose(t, 9, 2, 1.5, 0, 90);
  expectPose(t, -3, 0, 0, 0, 0);
  expectPose(t, 99, 2, 2, 0, 90);
}

// headings 135° and −135° are a quarter turn apart, by way of 180°
TEST(Trajectory, TurnsTheShorterWay)
{
  const auto t = read("waypoints = [0 0 0] [-1 1 0] [-2 0 0]\nspeed = 1\nturnRate = 90");
  EXPECT_NEAR(t.duration(), 2 * std::sqrt(2.0) + 1, 1e-12);
  expectPose(t, std::sqrt(2.0) + 0.5, -1, 1, 0, 180);
}

// 3-4-5: 5 m of way, of which 4 m up; then straight up, keeping the heading
TEST(Trajectory, ClimbsBetweenWayPointsWithoutPitch)
{
  const auto t = read("waypoints = [0 0 0] [0 3 4] [0 3 5]\nspeed = 1");
  EXPECT_DOUBLE_EQ(t.duration(), 6);
  EXPECT_FALSE(t.isFlat());
  expectPose(t, 2.5, 0, 1.5, 2, 90);
  expectPose(t, 5.5, 0, 3, 4.5, 90);
  EXPECT_EQ(t.poseAt(2.5).pitch(), 0);
}

TEST(Trajectory, InterpolatesPoses)
{
  const auto t = read("poses = [5  0 0 1  170 0 0]  [7  2 4 2  -170 20 -8]");
  EXPECT_DOUBLE_EQ(t.duration(), 2);
  expectPose(t, 0, 0, 0, 1, 170);
  expectPose(t, 1, 1, 2, 1.5, 180);
  expectPose(t, 2, 2, 4, 2, -170);
  EXPECT_NEAR(t.poseAt(1).pitch(), DEG2RAD(10.0), 1e-12);
  EXPECT_NEAR(t.poseAt(1).roll(), DEG2RAD(-4.0), 1e-12);
  EXPECT_FALSE(t.isFlat());
}

// A floor, on it a step of 0.25 m from x = 2 on, and from x = 4 on a slab 0.5 m above that: no room
// for a robot that needs 0.6 m, which goes over the slab.
TEST(Trajectory, FollowsTheLowestGroundWithRoom)
{
  const auto world = worldOf(R"(
[box.floor]
min = -9 -9 -0.5
max = 9 9 0
[box.step]
min = 2 -9 -0.5
max = 9 9 0.25
[box.slab]
min = 4 -9 0.75
max = 9 9 1
)");
  const std::string keys = "waypoints = [0 0] [6 0]\nspeed = 1\nfollowGround = yes\nheight = 0.3\n";
  const auto t = read(keys + "headroom = 0.3", world);
  EXPECT_NEAR(t.duration(), 6, 1e-9);
  const auto heightAt = [&](double time) { return t.poseAt(time).z(); };
  EXPECT_NEAR(heightAt(0), 0.3, 1e-12);
  EXPECT_NEAR(heightAt(1.9), 0.3, 1e-12);
  // at no time in the step, whose edge is at 2 m
  for (double time = 1.9; time < 2.1; time += 0.001)
    EXPECT_GE(heightAt(time), time < 2 ? 0.3 : 0.55) << time;
  EXPECT_NEAR(heightAt(2.1), 0.55, 1e-12);
  EXPECT_NEAR(heightAt(5), 1.3, 1e-12);
  EXPECT_NEAR(t.poseAt(5).x(), 5, 1e-9);
  EXPECT_NEAR(read(keys + "headroom = 0.1", world).poseAt(5).z(), 0.55, 1e-12);  // now it fits
}

TEST(Trajectory, NamesWhatIsWrong)
{
  const std::string drive = "speed = 1\n";
  const std::vector<std::pair<std::string, std::string>> bad{
      {drive, "waypoints = '' is not valid: it must be at least two times x y z [m]"},
      {drive + "waypoints = [0 0 0]", "waypoints = '[0 0 0]'"},
      {drive + "waypoints = [0 0 0] [1 1]", "at least two times x y z"},
      {drive + "waypoints = [0 0 0] [a 1 1]", "a list of finite numbers"},
      {drive + "waypoints = [1 2 3] [1 2 3]", "way-point 2 at (1, 2, 3)"},
      {"waypoints = [0 0 0] [1 0 0]", "speed = '' is not valid: it must be a number > 0"},
      {"waypoints = [0 0 0] [1 0 0]\nspeed = -1", "speed = '-1'"},
      {drive + "waypoints = [0 0 0] [1 0 0]\nturnRate = 0", "turnRate = '0'"},
      {drive + "waypoints = [0 0 0] [1 0 0]\nturnrate2 = 5", "'turnrate2' is not a key"},
      {drive + "waypoints = [0 0 0] [1 0 0]\nheight = 5", "'height' is not a key"},
      {drive + "waypoints = [0 0] [1 0]\nfollowGround = 1\nheight = -1", "height = '-1'"},
      {drive + "waypoints = [0 0] [1 0]\nfollowGround = 1", "way-point 1 at (0, 0, 0)"},
      {"poses = [0 0 0 0 0 0 0]", "at least two times t x y z yaw pitch roll"},
      {"poses = [1 0 0 0 0 0 0] [1 1 0 0 0 0 0]", "the time of pose 2"},
      {"poses = [0 0 0 0 0 0 0] [1 1 0 0 0 0 0]\nwaypoints = [0 0 0] [1 0 0]", "poses = "},
      {"poses = [0 0 0 0 0 0 0] [1 1 0 0 0 0 0]\nspeed = 1", "'speed' is not a key"},
  };
  for (const auto& [keys, part] : bad)
  {
    const auto message = messageOf([&, text = keys] { read(text); });
    EXPECT_TRUE(contains(message, "section 'trajectory': ")) << message;
    EXPECT_TRUE(contains(message, part)) << message << "\nfor:\n" << keys;
  }
}
