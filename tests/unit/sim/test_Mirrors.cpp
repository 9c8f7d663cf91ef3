#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/sim/Sensors.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "RoomFixtures.h"
#include "WorldText.h"

// Rays that are reflected on their way: where they end, what the sensor takes that for, how many.
namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim::fixtures;
using mrpt::DEG2RAD;
using mrpt::math::TPoint3D;
using mrpt::math::TPoint3Df;
using mrpt::math::TVector3D;
using mrpt::poses::CPose3D;
using mrpt_mapconv::test::worldOf;
using sim::RayCaster;
using sim::Scan;
using sim::World;

/** Four rays: ahead, left, behind, right. */
const std::string kCross =
    "[sensor.l]\nkind = lidar\nelevations = 0\nazimuthSteps = 4\nrate = 1\nmaxRange = 40\n";

std::unique_ptr<sim::Sensor> sensorOf(const std::string& text)
{
  const mrpt::config::CConfigFileMemory ini(text);
  std::vector<std::string> sections;
  ini.getAllSections(sections);
  params::StrictSection section(ini, sections.at(0));
  return sim::readSensor(section);
}

/** A scan, where its sensor takes its points to be [m], and which bodies returned them. */
struct Seen
{
  Scan scan;
  std::vector<TPoint3D> points;
  std::vector<std::string> bodies;
};

Seen seenIn(const World& world, const std::string& sensor, const CPose3D& robot,
            std::uint64_t key = 1)
{
  const RayCaster caster(world);
  Seen seen{sensorOf(sensor)->scan(caster, robot, key), {}, {}};
  const auto sensed = observation::sensorPoints(*seen.scan.observation, robot);
  if (sensed)
    for (const auto& p : sensed->points)
      seen.points.push_back(sensed->sensorPose.composePoint(TPoint3D(p)));
  EXPECT_EQ(seen.scan.truePoints.size(), seen.points.size());
  for (const std::int32_t body : seen.scan.bodies)
    seen.bodies.push_back(world.name(static_cast<std::size_t>(body)));
  EXPECT_EQ(seen.bodies.size(), seen.points.size());
  EXPECT_EQ(seen.scan.mirrored.size(), seen.points.size());
  return seen;
}

std::string wall(const std::string& name, const std::string& min, const std::string& max,
                 const std::string& mirror = "0")
{
  return "[box." + name + "]\nmin = " + min + "\nmax = " + max + "\nmirror = " + mirror + "\n";
}

/** One return, as the sensor takes it and as it is. */
void expectReturn(const Seen& seen, std::size_t i, const TPoint3D& point, const TPoint3D& place,
                  const std::string& body, bool mirrored)
{
  SCOPED_TRACE("return " + std::to_string(i));
  ASSERT_LT(i, seen.points.size());
  EXPECT_LT((seen.points[i] - point).norm(), 1e-4) << seen.points[i];
  EXPECT_LT((TPoint3D(seen.scan.truePoints[i]) - place).norm(), 1e-4) << seen.scan.truePoints[i];
  EXPECT_EQ(seen.bodies[i], body);
  EXPECT_EQ(seen.scan.mirrored[i], mirrored ? 1 : 0);
}

// --- worked out by hand

const std::string kMirrorAhead = wall("mirror", "2 -9 -1", "2.2 9 3", "1");  // x = 2
const std::string kTarget = wall("target", "-1.2 -9 -1", "-1 9 3");          // x = -1

TEST(Mirrors, WhatIsBehindTheRobotIsSeenBehindTheMirror)
{
  const World world = worldOf(kMirrorAhead + kTarget);
  const Seen seen = seenIn(world, kCross, CPose3D(0, 0, 1, 0, 0, 0));
  ASSERT_EQ(seen.points.size(), 2u);
  expectReturn(seen, 0, {5, 0, 1}, {-1, 0, 1}, "box.target", true);  // 2 m there and 3 m back
  expectReturn(seen, 1, {-1, 0, 1}, {-1, 0, 1}, "box.target", false);
}

TEST(Mirrors, TheWholeWayIsWithinTheRanges)
{
  const World world = worldOf(kMirrorAhead + kTarget);
  const CPose3D robot(0, 0, 1, 0, 0, 0);
  const std::string sensor = "[sensor.s]\nkind = lidar\nelevations = 0\nazimuthSteps = 1\nrate=1\n";
  EXPECT_EQ(seenIn(world, sensor + "maxRange = 5.01", robot).points.size(), 1u);
  EXPECT_EQ(seenIn(world, sensor + "maxRange = 4.99", robot).points.size(), 0u);
  EXPECT_EQ(seenIn(world, sensor + "maxRange = 9\nminRange = 4.99", robot).points.size(), 1u);
  EXPECT_EQ(seenIn(world, sensor + "maxRange = 9\nminRange = 5.01", robot).points.size(), 0u);
  // noise brings nothing back that is too far
  const std::string noisy =
      "[sensor.s]\nkind = scanner2D\nfieldOfView = 1\nrays = 1000\nrate = 1\nrangeNoise = 0.3\n";
  EXPECT_GT(seenIn(world, noisy + "maxRange = 9", robot).points.size(), 990u);
  EXPECT_EQ(seenIn(world, noisy + "maxRange = 4.99", robot).points.size(), 0u);
}

TEST(Mirrors, AMirrorThatReflectsNothingIsAWall)
{
  const World world = worldOf(wall("dull", "2 -9 -1", "2.2 9 3", "0") + kTarget);
  const Seen seen = seenIn(world, kCross, CPose3D(0, 0, 1, 0, 0, 0));
  expectReturn(seen, 0, {2, 0, 1}, {2, 0, 1}, "box.dull", false);
}

// Not even rays that hardly touch it, of which any mirror would reflect nearly all.
TEST(Mirrors, GlassThatReflectsNothingOnlyLetsThrough)
{
  const World world =
      worldOf("[pane.clear]\nfrom = 2 -90\nto = 2 90\nbottom = -1\ntop = 3\ntransparency = 0.5\n" +
              wall("far", "3 -400 -1", "4 400 3"));
  const Seen seen = seenIn(
      world, "[sensor.s]\nkind = scanner2D\nfieldOfView = 1\nrays = 1000\nrate = 1\nmaxRange = 900",
      CPose3D(1.9, 0, 1, DEG2RAD(89.0), 0, 0));
  std::map<std::string, int> counts;
  for (const auto& body : seen.bodies) ++counts[body];
  EXPECT_EQ(counts["pane.clear"] + counts["box.far"], 1000);
  EXPECT_NEAR(counts["pane.clear"], 500, 4 * std::sqrt(250.0)) << "key 1";
  for (const auto mirrored : seen.scan.mirrored) EXPECT_EQ(mirrored, 0);
}

// Eight times there and back, then the ninth meeting returns the ray: 2 + 8·4 m.
TEST(Mirrors, BetweenTwoMirrorsARayIsReflectedEightTimes)
{
  const World world = worldOf(kMirrorAhead + wall("opposite", "-2.2 -9 -1", "-2 9 3", "1"));
  const Seen seen = seenIn(world, kCross, CPose3D(0, 0, 1, 0, 0, 0));
  ASSERT_EQ(seen.points.size(), 2u);
  expectReturn(seen, 0, {34, 0, 1}, {2, 0, 1}, "box.mirror", true);
  expectReturn(seen, 1, {-34, 0, 1}, {-2, 0, 1}, "box.opposite", true);
}

// Two mirrors at a right angle send a ray back where it came from: all is mirrored at (2, 2).
TEST(Mirrors, ACornerOfMirrorsTurnsARayBack)
{
  const World world = worldOf(kMirrorAhead + wall("left", "-9 2 -1", "2 2.2 3", "1") + kTarget);
  const double angle = DEG2RAD(30.0), range = 5 / std::cos(angle);
  const Seen seen = seenIn(world, kCross, CPose3D(0, 0, 1, angle, 0, 0));
  expectReturn(seen, 0, {5, range * std::sin(angle), 1}, {-1, 4 - range * std::sin(angle), 1},
               "box.target", true);
}

// Through the pane, back through it once more.
TEST(Mirrors, AreSeenThroughGlass)
{
  const World world = worldOf(kMirrorAhead + kTarget +
                              "[pane.glass]\nfrom = 1 -9\nto = 1 9\nbottom = -1\ntop = 3\n"
                              "thickness = 0.02\ntransparency = 1\n");
  const Seen seen = seenIn(world, kCross, CPose3D(0, 0, 1, 0, 0, 0));
  expectReturn(seen, 0, {5, 0, 1}, {-1, 0, 1}, "box.target", true);
}

// Seven panes and the mirror are eight; on the way back the last pane returns the ray.
TEST(Mirrors, CountTogetherWithPanes)
{
  std::string text = kMirrorAhead + kTarget;
  for (int i = 1; i <= 7; ++i)
  {
    const std::string x = std::to_string(0.2 * i);
    text += "[pane.p" + std::to_string(i) + "]\nfrom = " + x + " -9\nto = " + x +
            " 9\nbottom = -1\ntop = 3\nthickness = 0.02\ntransparency = 1\n";
  }
  const World world = worldOf(text);
  const Seen seen = seenIn(world, kCross, CPose3D(0, 0, 1, 0, 0, 0));
  expectReturn(seen, 0, {2 + 0.59, 0, 1}, {1.41, 0, 1}, "pane.p7", true);
}

// --- against closed forms, ray by ray

/** The room with a perfect mirror for its east wall: it seems to reach from x = -5 to 15. */
double rangeInMirroredRoom(const TPoint3D& p, const TVector3D& d)
{
  const double low[] = {-5, -4, 0}, high[] = {15, 4, 3};
  double range = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    if (d[i] != 0) range = std::min(range, ((d[i] > 0 ? high[i] : low[i]) - p[i]) / d[i]);
  return range;
}

TEST(Mirrors, DoubleTheRoomForEverySensor)
{
  std::string text = kRoom;
  const std::string east = "[box.east]\n";
  text.insert(text.find(east) + east.size(), "mirror = 1\n");
  const World world = worldOf(text);
  const CPose3D robot(1, -1.5, 0.1, DEG2RAD(7.0), DEG2RAD(4.0), DEG2RAD(-6.0));
  std::string camera = kCamera;
  camera.replace(camera.find("6.5"), 3, "30");  // it has a range for all that it sees
  for (const auto& sensor : {kLidar, camera, kScanner})
  {
    const Seen seen = seenIn(world, sensor, robot);
    const TPoint3D origin = (robot + sensorOf(sensor)->params().pose).translation();
    std::size_t ghosts = 0;
    for (std::size_t i = 0; i < seen.points.size(); ++i)
    {
      const TPoint3D way = seen.points[i] - origin;
      // a camera's ranges are rounded to 0.1 mm along its axis, or to 1 mm beyond 6.5 m
      const double slack = sensor == camera ? 1e-3 : 1e-4;
      ASSERT_NEAR(way.norm(), rangeInMirroredRoom(origin, way.unitarize()), slack) << "ray " << i;
      const bool ghost = seen.points[i].x > 5 + slack;
      if (std::abs(seen.points[i].x - 5) < slack) continue;  // at the mirror's rim
      ASSERT_EQ(seen.scan.mirrored[i], ghost ? 1 : 0) << "ray " << i;
      const TPoint3D& p = seen.points[i];
      const TPoint3D place = ghost ? TPoint3D(10 - p.x, p.y, p.z) : p;
      ASSERT_LT((TPoint3D(seen.scan.truePoints[i]) - place).norm(), 2 * slack) << "ray " << i;
      ASSERT_LT(offRoom(TPoint3D(seen.scan.truePoints[i])), 2e-4) << "ray " << i;
      ghosts += ghost ? 1 : 0;
    }
    EXPECT_EQ(seen.points.size(), sensorOf(sensor)->rays()) << sensor;
    EXPECT_GT(ghosts, 20u) << sensor;
  }
}

// A mirror that is turned: what is seen is the mirror image of what is there.
TEST(Mirrors, TurnedOnesFoldTheWayAboutTheirNormal)
{
  const double yaw = DEG2RAD(25.0);
  const World world = worldOf(kRoom + wall("steel", "2 -1 0", "2.4 1 2", "1") + "yaw = 25\n");
  const TVector3D normal(-std::cos(yaw), -std::sin(yaw), 0);
  const TPoint3D onFace = TPoint3D(2.2, 0, 0) + normal * 0.2;
  const auto above = [&](const TPoint3D& p)
  { return (p.x - onFace.x) * normal.x + (p.y - onFace.y) * normal.y; };
  const Seen seen = seenIn(world,
                           "[sensor.l]\nkind = lidar\nbeams = 21\nelevationMin = -20\n"
                           "elevationMax = 15\nazimuthSteps = 720\nrate = 1\nmaxRange = 40\n",
                           CPose3D(0, -0.3, 1, 0, 0, 0));
  std::size_t ghosts = 0;
  for (std::size_t i = 0; i < seen.points.size(); ++i)
  {
    const TPoint3D place(seen.scan.truePoints[i]);
    ASSERT_LT(offRoom(place), 2e-4) << "ray " << i;  // the steel itself never returns a ray
    if (!seen.scan.mirrored[i]) continue;
    ++ghosts;
    const TPoint3D image = seen.points[i] - normal * (2 * above(seen.points[i]));
    // from where the robot stands only the face towards it is seen
    ASSERT_LT((place - image).norm(), 2e-4) << "ray " << i;
  }
  EXPECT_GT(ghosts, 500u);
}

// --- how many

/** Schlick (1994), from the angle to the normal. */
double schlick(double mirror, double angle)
{
  return mirror + (1 - mirror) * std::pow(1 - std::cos(angle), 5);
}

/** Ways along a mirror at x = 2, and far walls all around. */
const std::string kLongMirror = "min = 2 -150 -1\nmax = 2.2 150 3\n";
const std::string kFarWalls = wall("back", "-1.2 -150 -1", "-1 150 3") +
                              wall("south", "-1 -160 -1", "2 -150 3") +
                              wall("north", "-1 150 -1", "2 160 3");

TEST(Mirrors, ReflectTheShareThatSchlickSays)
{
  constexpr int kRays = 20000;
  constexpr std::uint64_t kKey = 31;
  const std::string sensor =
      "[sensor.s]\nkind = scanner2D\nfieldOfView = 1\nrays = " + std::to_string(kRays) +
      "\nrate = 1\nmaxRange = 400\n";
  for (const double mirror : {0.06, 0.6})
  {
    const World world =
        worldOf("[world]\nbounds = -9 -200 -2 9 200 9\n[box.mirror]\n" + kLongMirror +
                "mirror = " + std::to_string(mirror) + "\n" + kFarWalls);
    for (const double angle : {0.0, 30.0, 60.0, 75.0, 80.0, 85.0})
    {
      const Seen seen = seenIn(world, sensor, CPose3D(1, 0, 1, DEG2RAD(angle), 0, 0), kKey);
      ASSERT_EQ(seen.points.size(), std::size_t(kRays));
      double expected = 0, variance = 0, reflected = 0;
      for (int i = 0; i < kRays; ++i)
      {
        const double p = schlick(mirror, DEG2RAD(angle - 0.5 + 1.0 * i / (kRays - 1)));
        expected += p;
        variance += p * (1 - p);
        reflected += seen.scan.mirrored[std::size_t(i)];
        EXPECT_EQ(seen.bodies[std::size_t(i)] == "box.mirror", !seen.scan.mirrored[std::size_t(i)]);
      }
      EXPECT_NEAR(reflected, expected, 4 * std::sqrt(variance))
          << "key " << kKey << ", mirror " << mirror << ", " << angle << " degrees";
    }
  }
}

// 3 of 10 are reflected; half of the others go through, half return from the face ahead. Which
// returns are missing has nothing to do with that.
TEST(Mirrors, TransparencyIsOfTheRaysThatAreNotReflected)
{
  constexpr std::uint64_t kKey = 17;
  const World world = worldOf(
      "[pane.glass]\nfrom = 2 -9\nto = 2 9\nbottom = -1\ntop = 3\nthickness = 0.02\n"
      "transparency = 0.5\nmirror = 0.3\n" +
      kTarget + wall("far", "7 -9 -1", "8 9 3"));
  const std::string sensor =
      "[sensor.s]\nkind = scanner2D\nfieldOfView = 1\nrays = 20000\nrate = 1\nmaxRange = 40\n"
      "dropout = 0.4\n";
  for (const double yaw : {0.0, 180.0})  // from either side
  {
    const CPose3D robot(yaw > 0 ? 4 : 0, 0, 1, DEG2RAD(yaw), 0, 0);
    const Seen seen = seenIn(world, sensor, robot, kKey);
    const auto returns = static_cast<double>(seen.points.size());
    const std::string before = yaw > 0 ? "box.far" : "box.target";
    std::map<std::string, double> counts;
    for (std::size_t i = 0; i < seen.points.size(); ++i)
    {
      ++counts[seen.bodies[i]];
      EXPECT_EQ(seen.scan.mirrored[i] == 1, seen.bodies[i] == before) << "ray " << i;
      if (seen.bodies[i] != "pane.glass") continue;
      EXPECT_NEAR(seen.scan.truePoints[i].x, yaw > 0 ? 2.01 : 1.99, 1e-4) << "ray " << i;
    }
    const auto expectShare = [&](const std::string& body, double share)
    {
      EXPECT_NEAR(counts[body], share * returns, 4 * std::sqrt(share * (1 - share) * returns))
          << body << ", key " << kKey << ", yaw " << yaw;
    };
    expectShare("pane.glass", 0.35);
    expectShare(before, 0.3);
    expectShare(yaw > 0 ? "box.target" : "box.far", 0.35);
  }
}

TEST(Mirrors, TheKeyDecidesWhichRaysAreReflected)
{
  const World world = worldOf(kRoom + wall("steel", "2 -1 0", "2.4 1 2", "0.6"));
  const auto scan = [&](std::uint64_t key) { return seenIn(world, kLidar, CPose3D(), key).scan; };
  const Scan one = scan(1), again = scan(1), other = scan(2);
  EXPECT_EQ(one.truePoints, again.truePoints);
  EXPECT_EQ(one.bodies, again.bodies);
  EXPECT_EQ(one.mirrored, again.mirrored);
  EXPECT_NE(one.mirrored, other.mirrored);
}
}  // namespace
