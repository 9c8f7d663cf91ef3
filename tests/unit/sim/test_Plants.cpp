// What stands on the ground: solids by hand, and rays that meet them.
#include <gtest/gtest.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/Sensors.h>

#include <cmath>
#include <random>
#include <string>

#include "PlantWorlds.h"
#include "WorldText.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;
using namespace mrpt_mapconv::test;

void expectPlant(const World& world, double x, double y, const Solid& right)
{
  SCOPED_TRACE("at " + std::to_string(x) + " " + std::to_string(y));
  const auto solids = plantsAt(world, x, y);
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_NEAR(solids[0].bottom, right.bottom, 1e-6);
  EXPECT_NEAR(solids[0].top, right.top, 1e-6);
  EXPECT_NEAR(solids[0].slope, right.slope, 1e-6);
}

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
