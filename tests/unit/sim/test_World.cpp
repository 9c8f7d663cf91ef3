#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/World.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "WorldText.h"

namespace
{
using namespace mrpt_mapconv::sim;
using mrpt_mapconv::test::solidsAt;
using mrpt_mapconv::test::worldOf;

void expectError(const std::string& text, const std::string& message)
{
  try
  {
    worldOf(text, {"trajectory", "sensor."});
    FAIL() << "no error for " << text;
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(error.what(), message);
  }
}

constexpr char kWorld[] = "[world]\nbounds = -1 -2 -3 4 5 6\n";

TEST(World, IsReadFromAFile)
{
  const World world = worldOf(std::string(kWorld) +
                                  "[box.a]\nmin = 0 0 0\nmax = 1 1 1\n[sphere.b]\ncentre = 3 3 0\n"
                                  "radius = 1\n[sensor.lidar]\nx = 1\n[trajectory]\ny = 2\n",
                              {"trajectory", "sensor."});
  EXPECT_EQ(world.min(), mrpt::math::TPoint3D(-1, -2, -3));
  EXPECT_EQ(world.max(), mrpt::math::TPoint3D(4, 5, 6));
  ASSERT_EQ(world.size(), 2u);
  EXPECT_EQ(world.name(0), "box.a");
  EXPECT_EQ(world.name(1), "sphere.b");
}

TEST(World, BodiesAreKnownByTheBeginningOfTheirNames)
{
  const World world = worldOf(std::string(kWorld) + "[box.low_1]\nmin = 0 0 0\nmax = 1 1 1\n");
  for (const char* start : {"", "l", "low", "low_1"})
    EXPECT_TRUE(world.nameBegins(0, start)) << start;
  for (const char* start : {"b", "box", "box.low", "ow", "low_12"})
    EXPECT_FALSE(world.nameBegins(0, start)) << start;
}

TEST(World, BadFilesGetAnError)
{
  const std::string six = "six numbers, xMin yMin zMin xMax yMax zMax [m]";
  expectError("[box.a]\nmin = 0 0 0\nmax = 1 1 1\n[world]\nbound = 1\n",
              "section 'world': bounds = '' is not valid: it must be given: " + six);
  expectError("[world]\nbounds = 1 2 3\n",
              "section 'world': bounds = '1 2 3' is not valid: it must be " + six);
  expectError("[world]\nbounds = 0 0 0 1 0 1\n",
              "section 'world': bounds = '0 0 0 1 0 1' is not valid: it must be " + six +
                  ", each max above its min");
  expectError("[world]\nbounds = 0 0 0 1 1 1\ncolour = red\n",
              "section 'world': 'colour' is not a key of the world: correct its name or take it "
              "out");
  const std::string kinds =
      "it must be one of box, canopy, chair, cylinder, forest, heightField, log, pane, person, "
      "ramp, "
      "shelf, sphere, stairs, table, trunk, undergrowth";
  expectError("[bx.a]\nmin = 0 0 0\n", "section 'bx.a': 'bx' is not a kind of primitive: " + kinds);
  expectError("[trajectories]\nx = 1\n",
              "section 'trajectories': 'trajectories' is not a kind of primitive: " + kinds);
  expectError("[trajectory.a]\nx = 1\n",
              "section 'trajectory.a': 'trajectory' is not a kind of primitive: " + kinds);
  expectError("[box]\nmin = 0 0 0\nmax = 1 1 1\n",
              "section 'box' has no name of its own: it must be box.NAME");
}

TEST(World, BoundsMustHaveASize)
{
  EXPECT_THROW(World({0, 0, 0}, {1, 1, 0}), std::invalid_argument);
}

TEST(World, SolidsAreMergedWhereTheyTouchOrOverlap)
{
  const World world = worldOf(
      "[box.d]\nmin = 0 0 7\nmax = 1 1 8\n"      // apart
      "[box.c]\nmin = 0 0 2\nmax = 1 1 5\n"      // touches b
      "[box.a]\nmin = 0 0 -1\nmax = 1 1 1\n"     //
      "[box.b]\nmin = 0 0 0.5\nmax = 1 1 2\n"    // overlaps a
      "[box.inner]\nmin = 0 0 3\nmax = 1 1 4\n"  // within c
      "[ramp.e]\nmin = 0 0 7.5\nmax = 1 1 9.5\ndirection = +x\n");
  const auto solids = solidsAt(world, 0.5, 0.5);
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_EQ(solids[0].bottom, -1);
  EXPECT_EQ(solids[0].top, 5);
  EXPECT_EQ(solids[0].slope, 0);
  EXPECT_EQ(solids[1].bottom, 7);
  EXPECT_EQ(solids[1].top, 8.5);
  EXPECT_EQ(solids[1].slope, 2);  // of the ramp, which forms the top
  // where the ramp is still within the box, the box forms the top
  EXPECT_EQ(solidsAt(world, 0.2, 0.5).at(1).slope, 0);
}

TEST(World, TheCoarseGridChangesNothing)
{
  // bodies of all sizes, also beyond the bounds; the same question to each body by itself
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-40, 40), size(0.01, 9);
  std::string text = "[world]\nbounds = -20.3 -10.7 -5 21.1 15.2 9\n";
  for (int i = 0; i < 300; ++i)
  {
    const double x = place(random), y = place(random), z = 10.0 * i;  // they never touch
    text += "[box.b" + std::to_string(i) + "]\nmin = " + std::to_string(x) + " " +
            std::to_string(y) + " " + std::to_string(z) +
            "\nmax = " + std::to_string(x + size(random)) + " " + std::to_string(y + size(random)) +
            " " + std::to_string(z + 1) + "\nyaw = " + std::to_string(place(random)) + "\n";
  }
  const World world = worldOf(text);
  for (int i = 0; i < 20000; ++i)
  {
    const double x = place(random), y = place(random);
    std::vector<Solid> each;
    for (std::size_t p = 0; p < world.size(); ++p) world.primitive(p).appendSolids(x, y, each);
    ASSERT_EQ(solidsAt(world, x, y).size(), each.size()) << "at " << x << " " << y;
  }
}

TEST(World, PointsInsideBodies)
{
  const World world = worldOf("[box.a]\nmin = 0 0 0\nmax = 1 1 1\n");
  EXPECT_TRUE(world.isSolid({0.5, 0.5, 0.5}));
  EXPECT_TRUE(world.isSolid({0.5, 0.5, 1}));
  EXPECT_FALSE(world.isSolid({0.5, 0.5, 1.01}));
  EXPECT_FALSE(world.isSolid({1.01, 0.5, 0.5}));
}

TEST(World, SpheresThatHit)
{
  const World world = worldOf("[box.a]\nmin = 0 0 0\nmax = 1 1 1\n");
  EXPECT_TRUE(world.sphereHits({0.5, 0.5, 1.29}, 0.3));
  EXPECT_FALSE(world.sphereHits({0.5, 0.5, 1.31}, 0.3));
  EXPECT_FALSE(world.sphereHits({0.5, 0.5, 1.3}, 0.3)) << "it only touches";
  EXPECT_TRUE(world.sphereHits({1.2999, 0.503, 0.503}, 0.3)) << "a tenth of a millimetre";
  EXPECT_FALSE(world.sphereHits({1.3, 0.5, 0.5}, 0.3));
  EXPECT_TRUE(world.sphereHits({0.5, 0.5, 0.5}, 0.1)) << "all of it inside";
  EXPECT_TRUE(world.sphereHits({0.5, 0.5, 0.5}, 5)) << "the body inside of it";
  // near the upper edge along y, at 0.2 in x and in z: a distance of 0.2 * sqrt(2) = 0.2828
  EXPECT_TRUE(world.sphereHits({1.2, 0.5, 1.2}, 0.29));
  EXPECT_FALSE(world.sphereHits({1.2, 0.5, 1.2}, 0.28));
}

TEST(World, SpheresThatHitAtAWiderSpacing)
{
  const World world = worldOf("[cylinder.post]\nbase = 0 0 0\nradius = 0.02\nheight = 2\n");
  for (int i = 0; i < 63; ++i)
  {
    const double angle = 0.1 * i;
    const double x = std::cos(angle), y = std::sin(angle);
    EXPECT_TRUE(world.sphereHits({0.3 * x, 0.3 * y, 1}, 0.3)) << angle;
    EXPECT_FALSE(world.sphereHits({0.33 * x, 0.33 * y, 1}, 0.3)) << angle;
    EXPECT_TRUE(world.sphereHits({0.2 * x, 0.2 * y, 1}, 0.3, 0.025)) << angle;
  }
}

TEST(World, CeilingsCountForSpheres)
{
  const World world = worldOf("[box.roof]\nmin = 0 0 2\nmax = 9 9 3\n");
  EXPECT_FALSE(world.sphereHits({4, 4, 1.5}, 0.5));
  EXPECT_TRUE(world.sphereHits({4, 4, 1.51}, 0.5));
}
}  // namespace
