// How many rays pass through leaves, and where the others end.
#include <gtest/gtest.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/Sensors.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "PlantWorlds.h"
#include "WorldText.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;
using namespace mrpt_mapconv::test;

/** Share of the rays with different keys that end on the ground. */
double shareThrough(const World& world, const mrpt::math::TPoint3D& from,
                    const mrpt::math::TPoint3D& to)
{
  const RayCaster caster(world);
  constexpr int kRays = 20000;
  int through = 0;
  for (int i = 0; i < kRays; ++i)
  {
    const Hit hit = caster.cast(rayTo(from, to, std::uint64_t(i)), 0, 1000);
    EXPECT_GE(hit.primitive, 0);
    through += world.primitive(std::size_t(hit.primitive)).isGround() ? 1 : 0;
  }
  return double(through) / kRays;
}
/** Three standard deviations of a share of so many. */
double slackOf(double share) { return 3 * std::sqrt(share * (1 - share) / 20000); }
}  // namespace

TEST(Foliage, ShareOfRaysThroughACrownIsThatOfBeerAndLambert)
{
  const World world = worldOf(kFlat + kCrown);
  const double middle = std::exp(-0.4 * 4);
  EXPECT_NEAR(shareThrough(world, {2, 3, 15}, {2, 3, 1}), middle, slackOf(middle));
  // 3 m off the middle 3.2 m are left
  const double aside = std::exp(-0.4 * 3.2);
  EXPECT_NEAR(shareThrough(world, {5, 3, 15}, {5, 3, 1}), aside, slackOf(aside));
  EXPECT_EQ(shareThrough(world, {7.1, 3, 15}, {7.1, 3, 1}), 1);
  // from the crown's middle, half of the way is left
  const double half = std::exp(-0.4 * 2);
  EXPECT_NEAR(shareThrough(world, {2, 3, 8}, {2, 3, 1}), half, slackOf(half));
}

TEST(Foliage, CrownsThatOverlapTakeTheirSharesOneAfterTheOther)
{
  const World world = worldOf(
      kFlat + kCrown + "[canopy.b]\nplace = 2 3\nbottom = 7\ntop = 9\nradius = 5\ndensity = 0.3\n");
  const double share = std::exp(-0.4 * 4 - 0.3 * 2);
  EXPECT_NEAR(shareThrough(world, {2, 3, 15}, {2, 3, 1}), share, slackOf(share));
}

TEST(Foliage, SlantRaysGoALongerWayThroughUndergrowth)
{
  const World world = worldOf(
      kSlope + "[undergrowth.a]\nmin = -9 -9\nmax = 9 9\nheight = 0.5 0.5\ndensity = 1.2\n");
  const double down = std::exp(-1.2 * 0.5);
  EXPECT_NEAR(shareThrough(world, {1.1, 1.1, 15}, {1.1, 1.1, 0}), down, slackOf(down));
  // along y, at 45 degrees: through many patches
  const double slant = std::exp(-1.2 * 0.5 * std::sqrt(2));
  EXPECT_NEAR(shareThrough(world, {1.1, -7.1, 8 + 1.55}, {1.1, 0.9, 1.55}), slant, slackOf(slant));
}

TEST(Foliage, LeavesAreMetAnywhereInTheCrown)
{
  const World world = worldOf(kFlat + kCrown);
  const RayCaster caster(world);
  // of those that end within 4 m, how many in the first one
  int upper = 0, all = 0;
  for (std::uint64_t key = 0; key < 20000; ++key)
  {
    const Hit hit = caster.cast(rayTo({2, 3, 15}, {2, 3, 0}, key), 0, 100);
    if (world.name(std::size_t(hit.primitive)) != "canopy.a") continue;
    EXPECT_GE(hit.range, 5);
    EXPECT_LE(hit.range, 9);
    EXPECT_NEAR(hit.normal.z, 1, 1e-6);
    ++all;
    upper += hit.range < 6 ? 1 : 0;
  }
  EXPECT_NEAR(double(upper) / all, (1 - std::exp(-0.4)) / (1 - std::exp(-1.6)), 0.011);
}

TEST(Foliage, TheSameKeyMeetsTheSameLeaf)
{
  const World world = worldOf(kFlat + kCrown);
  const RayCaster caster(world), again(world);
  bool differs = false;
  for (std::uint64_t key = 0; key < 100; ++key)
  {
    const Ray ray = rayTo({2, 3, 15}, {2, 3, 0}, key);
    const Hit hit = caster.cast(ray, 0, 100);
    EXPECT_EQ(hit.range, again.cast(ray, 0, 100).range);
    // also if one only looks from the crown's middle on
    if (hit.range > 7)
    {
      EXPECT_EQ(hit.range, caster.cast(ray, 7, 100).range);
    }
    differs = differs || hit.range != caster.cast(rayTo({2, 3, 15}, {2, 3, 0}, 0), 0, 100).range;
  }
  EXPECT_TRUE(differs);
}

TEST(Foliage, ScansOfTheSameKeyMeetTheSameLeaves)
{
  const World world = worldOf(kFlat + kCrown);
  const RayCaster caster(world);
  const mrpt::config::CConfigFileMemory ini(
      std::string("[sensor.s]\nkind = lidar\nrate = 1\nmaxRange = 50\nazimuthSteps = 40\n"
                  "elevations = -80 -70 -60\n"));
  params::StrictSection section(ini, "sensor.s");
  const auto sensor = readSensor(section);
  const auto bodiesOf = [&](std::uint64_t key)
  { return sensor->scan(caster, mrpt::poses::CPose3D(2, 3, 15, 0, 0, 0), key).bodies; };
  EXPECT_EQ(bodiesOf(1), bodiesOf(1));
  EXPECT_NE(bodiesOf(1), bodiesOf(2));
}

TEST(Foliage, RaysOverAMirrorMeetLeavesByTheirOwnKeys)
{
  const World world =
      worldOf(kFlat +
              "[box.mirror]\nmin = 10 -9 1\nmax = 11 9 9\nmirror = 1\n[box.wall]\nmin = -15 -19 1\n"
              "max = -14 19 19\n[canopy.a]\nplace = -6 0\nbottom = 0\ntop = 8\nradius = 5\n"
              "density = 0.1\n");
  const RayCaster caster(world);
  const mrpt::config::CConfigFileMemory ini(
      std::string("[sensor.s]\nkind = scanner2D\nrate = 1\nmaxRange = 80\nrays = 41\n"
                  "fieldOfView = 4\n"));
  params::StrictSection section(ini, "sensor.s");
  const auto scan = readSensor(section)->scan(caster, mrpt::poses::CPose3D(5, 0, 5, 0, 0, 0), 1);
  std::size_t leaves = 0;
  for (std::size_t i = 0; i < scan.bodies.size(); ++i)
  {
    EXPECT_TRUE(scan.mirrored[i]);
    leaves += world.name(std::size_t(scan.bodies[i])) == "canopy.a" ? 1 : 0;
  }
  EXPECT_GT(leaves, 10u);  // 63 % of 41
  EXPECT_LT(leaves, 38u);
}
