#include <gtest/gtest.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/Sensors.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "WorldText.h"

// What stands on the ground: solids by hand, rays, and how many pass through leaves.
namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;
using mrpt_mapconv::test::solidsAt;
using mrpt_mapconv::test::worldOf;

/** Flat ground at z = 1, and a slope of 0.5 towards +x that is 1 at x = 0. @{ */
const std::string kFlat =
    "[heightField.g]\nmin = -20 -20\nmax = 20 20\ncell = 1\nsolid = below\nbase = 1\n";
const std::string kSlope =
    "[heightField.g]\nmin = -10 -10\nmax = 10 10\ncell = 0.5\nsolid = below\nbase = 1\n"
    "gradient = 0.5 0\n";
/** @} */

/** 4 m of leaves over (2, 3), from z = 6 on. */
const std::string kCrown =
    "[canopy.a]\nplace = 2 3\nbottom = 5\ntop = 9\nradius = 5\ndensity = 0.4\n";

/** Solids of what is not the ground. */
std::vector<Solid> plantsAt(const World& world, double x, double y)
{
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < world.size(); ++i)
    if (!world.primitive(i).isGround()) world.primitive(i).appendSolids(x, y, solids);
  return solids;
}

void expectPlant(const World& world, double x, double y, const Solid& right)
{
  SCOPED_TRACE("at " + std::to_string(x) + " " + std::to_string(y));
  const auto solids = plantsAt(world, x, y);
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_NEAR(solids[0].bottom, right.bottom, 1e-6);
  EXPECT_NEAR(solids[0].top, right.top, 1e-6);
  EXPECT_NEAR(solids[0].slope, right.slope, 1e-6);
}

/** A ray from above, or from elsewhere to a place. */
Ray rayTo(const mrpt::math::TPoint3D& from, const mrpt::math::TPoint3D& to, std::uint64_t key = 0)
{
  mrpt::math::TPoint3D d = to - from;
  d *= 1 / d.norm();
  return {mrpt::math::TPoint3Df(from), mrpt::math::TPoint3Df(d), key};
}

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

TEST(Plants, OnlyFieldsThatAreSolidBelowAreGround)
{
  const World world = worldOf(
      kFlat + "[box.a]\nmin = 0 0 1\nmax = 1 1 2\n[heightField.roof]\nmin = -5 -5\nmax = 5 5\n" +
      "cell = 1\nsolid = above\nbase = 6\n");
  EXPECT_NEAR(world.groundAt(0.5, 0.5).value(), 1, 1e-9);
  EXPECT_FALSE(world.groundAt(21, 0).has_value());
}

TEST(Plants, OfOverlappingGroundsTheHighestCounts)
{
  const World world =
      worldOf(kFlat + "[heightField.h]\nmin = 0 0\nmax = 2 2\ncell = 1\nsolid = below\nbase = 3\n");
  EXPECT_NEAR(world.groundAt(1, 1).value(), 3, 1e-9);
  EXPECT_NEAR(world.groundAt(-1, 1).value(), 1, 1e-9);
}

TEST(Plants, TrunkStandsOnTheGround)
{
  // its section comes before the ground's
  const World world = worldOf("[trunk.a]\nplace = 2 3\nradius = 0.5\nheight = 4\n" + kFlat);
  expectPlant(world, 2.3, 3.3, {1, 5, 0});
  EXPECT_TRUE(plantsAt(world, 2.4, 3.4).empty());
}

TEST(Plants, TrunkHasNoGapBelowItsFootOnASlope)
{
  const World world = worldOf("[trunk.a]\nplace = 2 3\nradius = 0.4\nheight = 4\n" + kSlope);
  expectPlant(world, 1.7, 3, {2 - 0.2, 6, 0});
}

TEST(Plants, TrunkTapers)
{
  const World world =
      worldOf("[trunk.a]\nplace = 0 0\nradius = 0.6\ntopRadius = 0.2\nheight = 4\n" + kFlat);
  expectPlant(world, 0.1, 0, {1, 5, 0});
  expectPlant(world, 0.4, 0, {1, 3, 10});  // half of the taper at half of the height
  EXPECT_TRUE(plantsAt(world, 0.61, 0).empty());
}

TEST(Plants, LogLiesOnTheGround)
{
  const World world = worldOf("[log.a]\nfrom = -2 1\nto = 3 1\nradius = 0.3\n" + kFlat);
  expectPlant(world, 0, 1, {1, 1.6, 0});
  expectPlant(world, 0, 1.18, {1.3 - 0.24, 1.3 + 0.24, 0.75});  // 3-4-5
  EXPECT_TRUE(plantsAt(world, 3.01, 1).empty());
  EXPECT_TRUE(plantsAt(world, 0, 1.31).empty());
}

TEST(Plants, LogFollowsASlope)
{
  const World world = worldOf("[log.a]\nfrom = -2 1\nto = 4 1\nradius = 0.2\n" + kSlope);
  // upright, the log is longer by 1/cos
  const double half = 0.2 * std::sqrt(1.25);
  expectPlant(world, 1, 1, {1.7 - half, 1.7 + half, 0.5});
}

TEST(Plants, LeavesAreSolidWhereTheWorldSaysSo)
{
  const std::string canopy =
      "[canopy.a]\nplace = 2 3\nbottom = 5\ntop = 9\nradius = 5\ndensity = 1\n";
  EXPECT_TRUE(plantsAt(worldOf(kFlat + canopy), 2, 3).empty());
  const World world = worldOf(kFlat + canopy + "solid = true\n");
  expectPlant(world, 2 + 1e-9, 3, {6, 10, 0});
  expectPlant(world, 5, 3, {8 - 1.6, 8 + 1.6, 0.75 * 0.4});
  EXPECT_TRUE(plantsAt(world, 7.01, 3).empty());
}

TEST(Plants, UndergrowthFollowsTheGround)
{
  const std::string ferns =
      "[undergrowth.a]\nmin = -5 -5\nmax = 5 5\nheight = 0.3 0.3\ndensity = 1\n";
  EXPECT_TRUE(plantsAt(worldOf(kSlope + ferns), 1, 1).empty());
  const World world = worldOf(kSlope + ferns + "solid = true\n");
  for (const double x : {-4.9, -0.3, 2.2, 5.0})
    expectPlant(world, x, 1, {1 + x / 2, 1 + x / 2 + 0.3, 0.5});
  EXPECT_TRUE(plantsAt(world, 5.01, 0).empty());
}

TEST(Plants, UndergrowthCoversItsShareWithHeightsInBetween)
{
  const World world = worldOf(kFlat +
                              "[undergrowth.a]\nmin = -10 -10\nmax = 10 10\nheight = 0.2 0.8\n"
                              "cover = 0.3\ncell = 0.2\ndensity = 1\nsolid = true\n");
  int covered = 0;
  double sum = 0, lowest = 9, highest = 0;
  for (int j = 0; j < 100; ++j)
    for (int i = 0; i < 100; ++i)
      for (const Solid& solid : plantsAt(world, -9.9 + 0.2 * i, -9.9 + 0.2 * j))
      {
        const double height = solid.top - solid.bottom;
        ++covered;
        sum += height;
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
      }
  EXPECT_NEAR(covered, 3000, 3 * 46);
  EXPECT_NEAR(sum / covered, 0.5, 0.01);
  EXPECT_GE(lowest, 0.2 - 1e-9);
  EXPECT_LE(highest, 0.8 + 1e-9);
  EXPECT_GT(highest - lowest, 0.55);
}

// --- rays

TEST(Plants, RaysSeeTimberAsTheTruthDoes)
{
  for (const std::string plant :
       {"[trunk.a]\nplace = 1 2\nradius = 1.5\ntopRadius = 0.3\nheight = 4\n",
        "[trunk.a]\nplace = 1 2\nradius = 0.4\ntopRadius = 1.2\nheight = 4\n",
        "[log.a]\nfrom = -4 -3\nto = 5 2\nradius = 1.1\n"})
  {
    SCOPED_TRACE(plant);
    const World world = worldOf(plant + kSlope);
    const RayCaster caster(world);
    const Footprint area = world.primitive(1).footprint();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(area.xMin - 0.2, area.xMax + 0.2),
        y(area.yMin - 0.2, area.yMax + 0.2);
    int inside = 0;
    for (int i = 0; i < 3000; ++i)
    {
      const double px = float(x(random)), py = float(y(random));
      const auto solids = plantsAt(world, px, py);
      if (plantsAt(world, px + 1e-4, py).size() != solids.size() ||
          plantsAt(world, px - 1e-4, py).size() != solids.size())
        continue;  // at the rim, single precision may decide otherwise
      const double ground = world.groundAt(px, py).value();
      const double top = solids.empty() ? ground : std::max(solids[0].top, ground);
      const Hit hit = caster.cast(rayTo({px, py, 15}, {px, py, -9}), 0, 100);
      ASSERT_NEAR(15 - hit.range, top, 1e-3) << px << " " << py;
      inside += top > ground ? 1 : 0;
    }
    EXPECT_GT(inside, 800);
  }
}

TEST(Plants, RaysMeetTimberFromAllSides)
{
  const World world =
      worldOf("[trunk.a]\nplace = 1 2\nradius = 1.5\ntopRadius = 0.3\nheight = 4\n" + kFlat);
  const CurvedSurface& trunk = *world.primitive(1).curved();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-6, 6);
  int met = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const mrpt::math::TPoint3D from(any(random), any(random), 3 + any(random));
    const mrpt::math::TPoint3D to(1 + any(random) / 8, 2 + any(random) / 8, 3 + any(random) / 4);
    mrpt::math::TVector3D d = to - from;
    d *= 1 / d.norm();
    const auto meeting = trunk.meet(from, d, 0, 100);
    if (!meeting) continue;
    ++met;
    // just before it is outside, just behind inside; or the other way round from inside
    const auto isInside = [&](double range)
    {
      const auto p = from + d * range;
      const auto solids = plantsAt(world, p.x, p.y);
      return !solids.empty() && solids[0].bottom < p.z && p.z < solids[0].top;
    };
    const double grazing = std::abs(meeting->outwards.x * d.x + meeting->outwards.y * d.y +
                                    meeting->outwards.z * d.z) /
                           meeting->outwards.norm();
    if (grazing < 1e-3) continue;
    EXPECT_NE(isInside(meeting->range - 1e-6), isInside(meeting->range + 1e-6)) << i;
    const bool goesIn =
        meeting->outwards.x * d.x + meeting->outwards.y * d.y + meeting->outwards.z * d.z < 0;
    EXPECT_EQ(isInside(meeting->range + 1e-6), goesIn) << i;
  }
  EXPECT_GT(met, 1000);
}

TEST(Plants, ShareOfRaysThroughACrownIsThatOfBeerAndLambert)
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

TEST(Plants, CrownsThatOverlapTakeTheirSharesOneAfterTheOther)
{
  const World world = worldOf(
      kFlat + kCrown + "[canopy.b]\nplace = 2 3\nbottom = 7\ntop = 9\nradius = 5\ndensity = 0.3\n");
  const double share = std::exp(-0.4 * 4 - 0.3 * 2);
  EXPECT_NEAR(shareThrough(world, {2, 3, 15}, {2, 3, 1}), share, slackOf(share));
}

TEST(Plants, SlantRaysGoALongerWayThroughUndergrowth)
{
  const World world = worldOf(
      kSlope + "[undergrowth.a]\nmin = -9 -9\nmax = 9 9\nheight = 0.5 0.5\ndensity = 1.2\n");
  const double down = std::exp(-1.2 * 0.5);
  EXPECT_NEAR(shareThrough(world, {1.1, 1.1, 15}, {1.1, 1.1, 0}), down, slackOf(down));
  // along y, at 45 degrees: through many patches
  const double slant = std::exp(-1.2 * 0.5 * std::sqrt(2));
  EXPECT_NEAR(shareThrough(world, {1.1, -7.1, 8 + 1.55}, {1.1, 0.9, 1.55}), slant, slackOf(slant));
}

TEST(Plants, LeavesAreMetAnywhereInTheCrown)
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

TEST(Plants, TheSameKeyMeetsTheSameLeaf)
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

TEST(Plants, ScansOfTheSameKeyMeetTheSameLeaves)
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

TEST(Plants, RaysOverAMirrorMeetLeavesByTheirOwnKeys)
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

// --- forests

namespace
{
const std::string kForest =
    "[forest.a]\nmin = -15 -15\nmax = 15 15\ntreesPerHectare = 500\nspacing = 1.5\n"
    "height = 8 12\ntrunkRadius = 0.1 0.3\ncrownRadius = 1 3\ncrownBase = 0.3 0.5\n"
    "density = 0.5\nlogsPerHectare = 100\nlogLength = 2 5\nlogRadius = 0.1 0.2\n";
}

TEST(Plants, ForestHasAsManyTreesAndLogsAsItsAreaTakes)
{
  const World world = worldOf(kFlat + kForest);
  std::size_t crowns = 0, timber = 0;
  for (std::size_t i = 1; i < world.size(); ++i)
  {
    EXPECT_EQ(world.name(i), "forest.a");
    ++(world.primitive(i).foliage() ? crowns : timber);
  }
  EXPECT_EQ(crowns, 45u);  // 500 on a hectare, on 0.09
  EXPECT_EQ(timber, 45u + 9u);
}

TEST(Plants, TreesOfAForestKeepWithinTheirLimits)
{
  std::string forest = kForest;
  forest.replace(forest.find("-15 -15"), 7, "-9 -9");
  forest.replace(forest.find("15 15"), 5, "9 9");
  const World world = worldOf(kSlope + forest);
  std::vector<mrpt::math::TPoint2D> places;
  for (std::size_t i = 1; i < world.size(); ++i)
  {
    const Foliage* crown = world.primitive(i).foliage();
    if (!crown) continue;
    const auto [low, high] = crown->boundsOf(0);
    const double x = (low.x + high.x) / 2, y = (low.y + high.y) / 2;
    const double ground = world.groundAt(x, y).value(), height = high.z - ground;
    EXPECT_GE(height, 8 - 1e-6);
    EXPECT_LE(height, 12 + 1e-6);
    EXPECT_GE((low.z - ground) / height, 0.3 - 1e-6);
    EXPECT_LE((low.z - ground) / height, 0.5 + 1e-6);
    EXPECT_GE(high.x - low.x, 2 - 1e-6);
    EXPECT_LE(high.x - low.x, 6 + 1e-6);
    EXPECT_LE(std::max(std::abs(x), std::abs(y)), 9);
    for (const auto& other : places) EXPECT_GE(std::hypot(x - other.x, y - other.y), 1.5 - 1e-6);
    places.push_back({x, y});
    // its trunk ends in the crown's middle
    const auto timber = plantsAt(world, x, y);
    ASSERT_FALSE(timber.empty());
    EXPECT_NEAR(timber[0].top, (low.z + high.z) / 2, 1e-6);
  }
  EXPECT_EQ(places.size(), 16u);
}

TEST(Plants, ForestDependsOnItsSeedAlone)
{
  const auto boundsOf = [](const World& world)
  {
    std::string text;
    for (std::size_t i = 1; i < world.size(); ++i)
    {
      const Footprint f = world.primitive(i).footprint();
      text += std::to_string(f.xMin) + " " + std::to_string(f.yMax) + "\n";
    }
    return text;
  };
  const std::string one = boundsOf(worldOf(kFlat + kForest));
  EXPECT_EQ(one, boundsOf(worldOf(kForest + kFlat)));
  EXPECT_NE(one, boundsOf(worldOf(kFlat + kForest + "seed = 2\n")));
}

// --- terraces

TEST(Terraces, RiseBySteps)
{
  const World world = worldOf(
      "[heightField.g]\nmin = 0 0\nmax = 40 2\ncell = 0.05\nsolid = below\ngradient = 0.2 0\n"
      "terraces = 0.5 1.5\n");
  std::vector<double> levels;
  for (double x = 0.01; x < 40; x += 0.05)
  {
    const double z = world.groundAt(x, 1).value();
    EXPECT_NEAR(z, 0.2 * x, 1.5);
    if (levels.empty() || z > levels.back() + 0.4) levels.push_back(z);
  }
  for (std::size_t i = 2; i + 1 < levels.size(); ++i)
  {
    EXPECT_GE(levels[i] - levels[i - 1], 0.4);
    EXPECT_LE(levels[i] - levels[i - 1], 1.51);
  }
  EXPECT_GE(levels.size(), 6u);
  EXPECT_LE(levels.size(), 17u);
}

TEST(Terraces, TiltIsTheShareThatIsNoStep)
{
  const std::string keys =
      "[heightField.g]\nmin = 0 0\nmax = 40 2\ncell = 0.05\nsolid = below\ngradient = 0.2 0\n";
  const World all = worldOf(keys + "terraces = 0.5 1.5\nterraceTilt = 1\n"), none = worldOf(keys);
  const World part = worldOf(keys + "terraces = 1 1\nterraceTilt = 0.4\n");
  for (double x = 0.01; x < 40; x += 0.37)
    EXPECT_NEAR(all.groundAt(x, 1).value(), none.groundAt(x, 1).value(), 1e-5);
  // a terrace is 5 m long
  EXPECT_NEAR(part.groundAt(9, 1).value(), 1 + 0.4 * 0.8, 1e-5);
  EXPECT_NEAR(solidsAt(part, 9, 1)[0].slope, 0.4 * 0.2, 1e-4);
}

// --- bad plants

namespace
{
struct BadPlant
{
  const char *text, *error;
};
class BadPlants : public testing::TestWithParam<BadPlant>
{
};
const BadPlant kBadPlants[] = {
    {"[trunk.a]\nplace = 30 3\nradius = 1\nheight = 1\n",
     "section 'trunk.a': place = '30 3' is not valid: it must be a place with ground (of a "
     "heightField) at it"},
    {"[trunk.a]\nplace = 3 3\nradius = 1\nheight = 0\n",
     "section 'trunk.a': height = '0' is not valid: it must be a number > 0"},
    {"[trunk.a]\nplace = 3 3\nradius = 1\nheight = 1\ntopRadius = 0\n",
     "section 'trunk.a': topRadius = '0' is not valid: it must be a number > 0"},
    {"[trunk.a]\nplace = 3 3\nradius = 1\nheight = 1\nbase = 0\n",
     "section 'trunk.a': 'base' is not a key of a trunk: correct its name or take it out"},
    {"[log.a]\nfrom = 3 3\nto = 3 3\nradius = 1\n",
     "section 'log.a': to = '3 3' is not valid: it must be another place than from"},
    {"[log.a]\nfrom = 3 3\nto = 3 33\nradius = 1\n",
     "section 'log.a': to = '3 33' is not valid: it must be a place with ground (of a heightField) "
     "at it"},
    {"[canopy.a]\nplace = 3 3\nbottom = 4\ntop = 4\nradius = 1\ndensity = 1\n",
     "section 'canopy.a': top = '4' is not valid: it must be above bottom"},
    {"[canopy.a]\nplace = 3 3\nbottom = 4\ntop = 5\nradius = 1\ndensity = 0\n",
     "section 'canopy.a': density = '0' is not valid: it must be a number > 0"},
    {"[canopy.a]\nplace = 3 3\nbottom = 4\ntop = 5\nradius = 1\ndensity = 1\nsolid = below\n",
     "section 'canopy.a': solid = 'below' is not valid: it must be true or false"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 3 4\nheight = 1 1\ndensity = 1\n",
     "section 'undergrowth.a': max = '3 4' is not valid: it must be above min in x and y"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 30 4\nheight = 1 1\ndensity = 1\n",
     "section 'undergrowth.a': max = '30 4' is not valid: it must be such that there is ground (of "
     "a heightField) in all of the area"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 4 4\nheight = 2 1\ndensity = 1\n",
     "section 'undergrowth.a': height = '2 1' is not valid: it must be two numbers, lowest and "
     "highest, 0 < lowest <= highest"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 4 4\nheight = 1 1\ndensity = 1\ncell = 0.0001\n",
     "section 'undergrowth.a': cell = '0.0001' is not valid: it must be so large that the area has "
     "at most 1e6 patches"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 4 4\nheight = 1 1\ndensity = 1\ncover = 0\n",
     "section 'undergrowth.a': cover = '0' is not valid: it must be above 0"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 4 4\nheight = 1 1\ndensity = 1\ncover = 1e-9\n",
     "section 'undergrowth.a': cover = '1e-9' is not valid: it must be so large that something "
     "grows in one of the patches"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\nterraces = 0 1\n",
     "section 'heightField.a': terraces = '0 1' is not valid: it must be two numbers, lowest and "
     "highest, 0 < lowest <= highest"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\nterraceTilt = 0.1\n",
     "section 'heightField.a': terraceTilt = '0.1' is not valid: it must be left out without "
     "terraces"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\nterraces = 1 1\n"
     "terraceTilt = 2\n",
     "section 'heightField.a': terraceTilt = '2' is not valid: it must be within 0 and 1"},
};
}  // namespace

TEST_P(BadPlants, GetAnErrorThatNamesSectionAndKey)
{
  try
  {
    worldOf(kFlat + GetParam().text);
    FAIL() << "no error for " << GetParam().text;
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(), GetParam().error);
  }
}
INSTANTIATE_TEST_SUITE_P(Plants, BadPlants, testing::ValuesIn(kBadPlants));

namespace
{
struct BadForest
{
  const char *key, *value, *error;
};
class BadForests : public testing::TestWithParam<BadForest>
{
};
const BadForest kBadForests[] = {
    {"treesPerHectare", "-1", "a number >= 0, for at most 1e5"},
    {"spacing", "-1", "a distance >= 0 [m]"},
    {"spacing", "9", "so small that all trees find room in the area"},
    {"height", "9 8", "two numbers, lowest and highest, 0 < lowest <= highest"},
    {"trunkRadius", "0 1", "two numbers, lowest and highest, 0 < lowest <= highest"},
    {"crownRadius", "1", "two numbers, lowest and highest, 0 < lowest <= highest"},
    {"crownBase", "0.5 1", "shares of the height, below 1"},
    {"density", "-2", "a number > 0"},
    {"logLength", "99 99", "so small that logs find room in the area"},
    {"logRadius", "", "given: two numbers, lowest and highest, 0 < lowest <= highest"},
    {"max", "30 15", "such that there is ground (of a heightField) in all of the area"},
};
}  // namespace

TEST_P(BadForests, GetAnErrorThatNamesTheKey)
{
  const auto& [key, value, right] = GetParam();
  std::string text = kForest;
  const auto begin = text.find("\n" + std::string(key) + " =") + 1, end = text.find('\n', begin);
  text.replace(begin, end - begin, *value ? std::string(key) + " = " + value : "");
  try
  {
    worldOf(kFlat + text);
    FAIL() << "no error for " << text;
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(error.what(), std::string("section 'forest.a': ") + key + " = '" + value +
                                "' is not valid: it must be " + right);
  }
}
TEST(Plants, ForestsHaveAtMostAHundredThousandTrees)
{
  std::string forest = kForest;
  forest.replace(forest.find("-15 -15"), 7, "-20 -20");
  forest.replace(forest.find("15 15"), 5, "20 20");
  forest.replace(forest.find("500"), 3, "9e5");
  EXPECT_THROW(worldOf(kFlat + forest), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(Plants, BadForests, testing::ValuesIn(kBadForests));
