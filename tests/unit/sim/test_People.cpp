#include <gtest/gtest.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/sim/SimulationFiles.h>

#include <cmath>
#include <string>
#include <vector>

#include "RoomFixtures.h"
#include "WorldText.h"

// People that walk: where they are when, who sees them, and that they are no part of the truth.
namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim::fixtures;
using mrpt_mapconv::test::solidsAt;
using mrpt_mapconv::test::worldOf;
using mrpt_mapconv::testing::contains;
using mrpt_mapconv::testing::messageOf;
using mrpt_mapconv::testing::readBytes;
using sim::Ray;
using sim::RayCaster;
using sim::Simulator;
using sim::World;

const std::string kThereAndBack = "[person.anna]\npath = 2 0  6 0\nspeed = 1\n";
const Ray kAhead{{0, 0, 1}, {1, 0, 0}};

TEST(People, WalkToTheEndAndBackForEver)
{
  const World world = worldOf(kThereAndBack);
  RayCaster caster(world);
  const auto expectAt = [&](double seconds, double x)
  {
    caster.moveTo(seconds);
    EXPECT_NEAR(caster.cast(kAhead, 0, 30).range, x - 0.2, 1e-5) << seconds << " s";
    EXPECT_NEAR(caster.cast({{float(x), 0, 5}, {0, 0, -1}}, 0, 30).range, 5 - 1.75, 1e-5);
  };
  EXPECT_NEAR(caster.cast(kAhead, 0, 30).range, 1.8, 1e-6) << "before it is asked to move";
  expectAt(0, 2);
  expectAt(1.25, 3.25);
  expectAt(4, 6);
  expectAt(5, 5);
  expectAt(8, 2);
  expectAt(9.5, 3.5);
  expectAt(8000 + 5, 5);
  expectAt(1, 3);  // and time may go back
}

TEST(People, TurnAtCornersAndStartWhereTheyAreToldTo)
{
  // 3 m, then 4 m; at 2 m/s, 1 s ahead
  const World world = worldOf(
      "[person.bob]\npath = 0 2  3 2  3 6\nspeed = 2\nstart = 1\nheight = 2\nradius = 0.5\n"
      "base = 0.5\n");
  RayCaster caster(world);
  const auto expectAt = [&](double seconds, float x, float y)
  {
    if (seconds > 0) caster.moveTo(seconds);
    const auto down = caster.cast({{x, y, 9}, {0, 0, -1}}, 0, 30);
    EXPECT_NEAR(down.range, 9 - 2.5, 1e-5) << seconds << " s";
    EXPECT_NEAR(caster.cast({{x, y, -9}, {0, 0, 1}}, 0, 30).range, 9.5, 1e-5) << seconds << " s";
    EXPECT_NEAR(caster.cast({{x - 9, y, 1}, {1, 0, 0}}, 0, 30).range, 8.5, 1e-5) << seconds;
    EXPECT_NEAR(caster.cast({{x, y - 9, 1}, {0, 1, 0}}, 0, 30).range, 8.5, 1e-5) << seconds;
  };
  expectAt(0, 2, 2);
  expectAt(0.5, 3, 2);
  expectAt(1.5, 3, 4);
  expectAt(2.5, 3, 6);
  expectAt(3.5, 3, 4);
  expectAt(5, 2, 2);
  expectAt(6, 0, 2);
  expectAt(7, 2, 2);
}

TEST(People, NeitherMoveNorHideWhatStands)
{
  const std::string standing = "[cylinder.post]\nbase = 4 0 0\nradius = 0.1\nheight = 3\n";
  const World world =
      worldOf(kThereAndBack + standing + "[person.bob]\npath = 9 3  9 -3\nspeed = 1\n");
  RayCaster caster(world);
  const auto nameOf = [&](const sim::Hit& hit)
  { return world.name(static_cast<std::size_t>(hit.primitive)); };
  const auto expectHit = [&](double seconds, float range, const std::string& body)
  {
    caster.moveTo(seconds);
    const auto hit = caster.cast(kAhead, 0, 30);
    EXPECT_NEAR(hit.range, range, 1e-5) << seconds << " s";
    EXPECT_EQ(nameOf(hit), body) << seconds << " s";
    EXPECT_EQ(hit.normal, mrpt::math::TPoint3Df(-1, 0, 0));
    EXPECT_NEAR(caster.cast({{4, 1, 1}, {0, -1, 0}}, 0, 30).range, seconds == 2 ? 0.8 : 0.9, 1e-5);
  };
  expectHit(0, 1.8f, "person.anna");
  expectHit(2, 3.8f, "person.anna");    // around the post
  expectHit(3, 3.9f, "cylinder.post");  // behind it
  EXPECT_NEAR(caster.cast({{5.5f, 0, 1}, {1, 0, 0}}, 0, 30).range, 3.3, 1e-5) << "bob, at 9 0";
  EXPECT_EQ(nameOf(caster.cast({{0, 0, 1.76f}, {1, 0, 0}}, 0, 30)), "cylinder.post")
      << "over their heads";
}

TEST(People, AreLookedThroughFromInside)
{
  const World world = worldOf(kThereAndBack + "[box.wall]\nmin = 8 -1 -1\nmax = 9 1 4\n");
  const RayCaster caster(world);
  EXPECT_NEAR(caster.cast({{2.1f, 0, 1}, {1, 0, 0}}, 0, 30).range, 5.9, 1e-5);
  EXPECT_EQ(caster.cast({{2, 0, 1}, {0, 0, 1}}, 0, 30).primitive, -1);
  // outside again they are there
  EXPECT_NEAR(caster.cast({{2.3f, 0, 1}, {-1, 0, 0}}, 0, 30).range, 0.1, 1e-5);
}

// --- they are no part of the truth

TEST(People, AreNoPartOfTheTruth)
{
  const std::string person = "[person.anna]\npath = -3 0  3 0\nspeed = 1\n";
  const World without = worldOf(kRoom), with = worldOf(kRoom + person);
  EXPECT_EQ(solidsAt(with, -3, 0).size(), 2u);  // floor and roof
  EXPECT_FALSE(with.isSolid({-3, 0, 1}));
  EXPECT_FALSE(with.sphereHits({-3, 0, 1}, 0.3));
  const auto frame = sim::frameOf(with, 0.25);
  EXPECT_EQ(truthLayers(with, frame, {}).ground.cells(),
            truthLayers(without, frame, {}).ground.cells());
  EXPECT_EQ(sim::obstacleLayer(with, frame, 0.1, 1.5).cells(),
            sim::obstacleLayer(without, frame, 0.1, 1.5).cells());
}

TEST(People, MayBeDrivenThrough)
{
  const auto scenario =
      load(kRoom + kScanner + kDrive + "[person.anna]\npath = 0 0  2 0\nspeed = 0.5\n");
  Simulator simulator(scenario, 1);
  std::size_t moments = 0;
  while (simulator.next()) ++moments;
  EXPECT_EQ(moments, 101u);
}

TEST(People, HaveTheFootprintOfTheirWholeWalk)
{
  const World world =
      worldOf("[person.bob]\npath = 1 2  -3 2  -3 6\nspeed = 1\nstart = 3\nradius = 0.5\n");
  const auto area = world.primitive(0).footprint();
  EXPECT_EQ(area.xMin, -3.5);
  EXPECT_EQ(area.yMin, 1.5);
  EXPECT_EQ(area.xMax, 1.5);
  EXPECT_EQ(area.yMax, 6.5);
}

TEST(People, MustComeIntoTheBounds)
{
  const auto text = [](const std::string& keys)
  { return kRoom + kScanner + kDrive + "[person.p]\nspeed = 1\n" + keys; };
  EXPECT_EQ(load(text("path = 9 0  5 0")).world.size(), 7u);
  for (const std::string keys : {"path = 9 0  8 0", "path = 0 0  1 0\nbase = 4"})
    EXPECT_TRUE(contains(messageOf([&] { load(text(keys)); }),
                         "section 'person.p': the body is outside the world's bounds"))
        << keys;
}

// --- they are seen by sensors

/** Stands at (0, 0) and looks along the axes, twice a second for 8 s. */
const std::string kLookout =
    "[sensor.l]\nkind = lidar\npose = 0 0 1  0 0 0\nelevations = 0\nazimuthSteps = 4\nrate = 2\n"
    "maxRange = 20\n[trajectory]\nposes = [0  0 0 0  0 0 0] [8  0 0 0  0 0 0]\n";

/** Where anna is in front of the lookout [m]. */
double annaAt(double seconds) { return seconds <= 4 ? 1 + 0.5 * seconds : 5 - 0.5 * seconds; }
const std::string kAnna = "[person.anna]\npath = 1 0  3 0\nspeed = 0.5\n";

TEST(People, AreWhereTheyAreAtTheMomentOfTheScan)
{
  const auto scenario = load(kRoom + kAnna + kLookout);
  Simulator simulator(scenario, 1);
  std::size_t moments = 0;
  while (const auto moment = simulator.next())
  {
    ++moments;
    const auto& scan = moment->scans.at(0);
    ASSERT_EQ(scan.bodies.size(), 4u);
    EXPECT_EQ(scenario.world.name(std::size_t(scan.bodies[0])), "person.anna");
    EXPECT_NEAR(scan.truePoints[0].x, annaAt(moment->seconds) - 0.2, 1e-5) << moment->seconds;
    EXPECT_NEAR(scan.truePoints[1].y, 4, 1e-5);
    EXPECT_EQ(scan.mirrored, (std::vector<std::uint8_t>{0, 0, 0, 0}));
  }
  EXPECT_EQ(moments, 17u);
}

TEST(People, AreInTheFilesOfASimulation)
{
  const auto scenario = load(kRoom + kAnna + kLookout);
  const TempDir dir;
  files::OutputDir out(dir.path());
  sim::simulateTo(out, scenario, 1);
  out.commit();
  const auto scans = observation::readRawlog(dir.path("scans.rawlog"));
  ASSERT_EQ(scans.size(), 17u);
  const double start = mrpt::Clock::toDouble(scans[0].observation->timestamp);
  for (const auto& scan : scans)
  {
    const double seconds = mrpt::Clock::toDouble(scan.observation->timestamp) - start;
    const auto seen = observation::sensorPoints(*scan.observation, scan.robotPose);
    ASSERT_EQ(seen->points.size(), 4u);
    EXPECT_NEAR(seen->points[0].x, annaAt(seconds) - 0.2, 1e-5) << seconds;
  }
}

TEST(People, AreSeenThroughGlassAndInMirrors)
{
  // anna walks behind the robot, from x = -1 to -3; the mirror ahead at x = 4, a pane before it
  const auto scenario =
      load(kRoom + kLookout +
           "[person.anna]\npath = -1 0  -3 0\nspeed = 0.5\n"
           "[box.mirror]\nmin = 4 -1 0\nmax = 4.5 1 2\nmirror = 1\n"
           "[pane.glass]\nfrom = 2 -1\nto = 2 1\nbottom = 0\ntop = 2\ntransparency = 1\n");
  Simulator simulator(scenario, 1);
  while (const auto moment = simulator.next())
  {
    const auto& scan = moment->scans.at(0);
    const double x = -annaAt(moment->seconds) + 0.2;
    for (const std::size_t i : {0u, 2u})
    {
      EXPECT_EQ(scenario.world.name(std::size_t(scan.bodies[i])), "person.anna");
      EXPECT_NEAR(scan.truePoints[i].x, x, 1e-4) << moment->seconds << " s, ray " << i;
      EXPECT_EQ(scan.mirrored[i], i == 0 ? 1 : 0);
    }
    const auto seen = observation::sensorPoints(*scan.observation, moment->pose);
    EXPECT_NEAR(seen->points[0].x, 8 - x, 1e-4) << "4 m there, and back to anna";
  }
}

TEST(People, AreTheSameForTheSameSeed)
{
  const auto scenario = load(kRoom + kAnna +
                             "[person.bob]\npath = -3 -3  3 3  3 -3\nspeed = 1.3\nstart = 2.5\n"
                             "[box.steel]\nmin = 4 -1 0\nmax = 4.5 1 2\nmirror = 0.6\n" +
                             kLidar + "rangeNoise = 0.01\ndropout = 0.05\n" + kDrive);
  const auto simulate = [&](const TempDir& dir, std::uint64_t seed)
  {
    files::OutputDir out(dir.path());
    sim::simulateTo(out, scenario, seed);
    out.commit();
    return readBytes(dir.path("scans.rawlog"));
  };
  const TempDir first, again, other;
  const std::string bytes = simulate(first, 1);
  EXPECT_TRUE(bytes == simulate(again, 1));
  EXPECT_TRUE(bytes != simulate(other, 2));
}
}  // namespace
