#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include "RandomBodies.h"
#include "WorldText.h"

// Where a robot would hit something between two heights.
namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;
using grid::Layer;
using mrpt_mapconv::test::RandomBodies;
using mrpt_mapconv::test::worldOf;

/** A floor with its upper face at z = 0 and bodies on it, in x, y from 0 to 1 m. */
World floorWith(const std::string& bodies)
{
  return worldOf("[world]\nbounds = 0 0 -0.1 1 1 5\n[box.floor]\nmin = 0 0 -0.5\nmax = 1 1 0\n" +
                 bodies);
}

Layer<float> obstaclesIn(const World& world, double zMin = 0.05, double zMax = 1.5)
{
  return obstacleLayer(world, frameOf(world, 0.1), zMin, zMax, 1);
}

/** Cells 1 of a layer from its lower left corner, by their columns and rows. */
using Cells = std::vector<std::pair<int, int>>;
Cells cellsWith(const Layer<float>& layer, float value)
{
  Cells cells;
  for (std::int32_t y = 0; y < layer.frame().height; ++y)
    for (std::int32_t x = 0; x < layer.frame().width; ++x)
      if (layer.at(x, y) == value) cells.emplace_back(x, y);
  return cells;
}

// --- worked out by hand

TEST(ObstacleLayer, CellsThatABodyReachesInto)
{
  // all of cell (2, 3), then a millimetre more, then a millimetre less
  EXPECT_EQ(cellsWith(obstaclesIn(floorWith("[box.a]\nmin = 0.2 0.3 0\nmax = 0.3 0.4 1\n")), 1),
            (Cells{{2, 3}}));
  EXPECT_EQ(cellsWith(obstaclesIn(floorWith("[box.a]\nmin = 0.2 0.3 0\nmax = 0.301 0.4 1\n")), 1),
            (Cells{{2, 3}, {3, 3}}));
  EXPECT_EQ(cellsWith(obstaclesIn(floorWith("[box.a]\nmin = 0.2 0.3 0\nmax = 0.299 0.399 1\n")), 1),
            (Cells{{2, 3}}));
  EXPECT_EQ(cellsWith(obstaclesIn(floorWith("[box.a]\nmin = 0.199 0.299 0\nmax = 0.3 0.4 1\n")), 1),
            (Cells{{1, 2}, {2, 2}, {1, 3}, {2, 3}}));
  // nothing else than free floor there
  const auto free = obstaclesIn(floorWith("[box.a]\nmin = 0.2 0.3 0\nmax = 0.3 0.4 1\n"));
  EXPECT_EQ(cellsWith(free, 0).size(), 99u);
}

TEST(ObstacleLayer, OnlyWhatIsBetweenTheHeightsCounts)
{
  const World world = floorWith("[box.top]\nmin = 0.2 0.3 0.7\nmax = 0.3 0.4 0.75\n");
  const auto hits = [&](double zMin, double zMax)
  { return cellsWith(obstaclesIn(world, zMin, zMax), 1).size(); };
  EXPECT_EQ(hits(0.05, 1.5), 1u);
  EXPECT_EQ(hits(0.05, 0.7), 0u);  // touching is not reaching into
  EXPECT_EQ(hits(0.05, 0.701), 1u);
  EXPECT_EQ(hits(0.75, 1.5), 0u);
  EXPECT_EQ(hits(0.749, 1.5), 1u);
  EXPECT_EQ(hits(0.71, 0.72), 1u);  // inside of it
  EXPECT_EQ(hits(-0.01, 0.5), 100u) << "the floor itself";
  EXPECT_EQ(hits(0, 0.5), 0u);
}

TEST(ObstacleLayer, ADoorWithALintelIsFreeForWhoFitsUnderIt)
{
  const World world = floorWith(
      "[box.left]\nmin = 0 0.42 0\nmax = 0.3 0.53 2.7\n[box.right]\nmin = 0.7 0.42 0\n"
      "max = 1 0.53 2.7\n[box.lintel]\nmin = 0.3 0.42 2.05\nmax = 0.7 0.53 2.7\n");
  EXPECT_EQ(cellsWith(obstaclesIn(world), 1).size(), 2u * 6);
  EXPECT_EQ(cellsWith(obstaclesIn(world, 0.05, 2.1), 1).size(), 2u * 10);
}

TEST(ObstacleLayer, WithoutGroundNothingIsKnown)
{
  const World world = worldOf(
      "[world]\nbounds = 0 0 -1 1 1 5\n[box.west]\nmin = 0 0 -0.5\nmax = 0.3 1 0\n"
      "[box.pit]\nmin = 0.6 0 -9\nmax = 1 1 -3\n[box.roof]\nmin = 0 0 2\nmax = 1 1 2.5\n"
      "[box.beam]\nmin = 0 0.5 1\nmax = 1 0.6 1.1\n");
  const auto layer = obstaclesIn(world);
  EXPECT_EQ(layer.at(2, 0), 0);
  EXPECT_EQ(layer.at(4, 0), -1) << "only a roof above";
  EXPECT_EQ(layer.at(7, 0), 0) << "ground is also what is deep below";
  EXPECT_EQ(layer.at(4, 5), 1) << "a beam without ground under it";
  EXPECT_EQ(cellsWith(layer, -1).size(), 3u * 9);
}

TEST(ObstacleLayer, CellsBeyondTheBoundsAreUnknown)
{
  const World world = worldOf(
      "[world]\nbounds = 0 0 -1 1 1 2\n[box.a]\nmin = -5 -5 -1\nmax = 5 5 0\n"
      "[box.b]\nmin = -5 0.4 0\nmax = 5 0.45 1\n");
  const auto layer = obstacleLayer(world, {0.5, -2, -2, 6, 6}, 0.05, 1.5, 1);
  for (std::int32_t iy = 0; iy < 6; ++iy)
    for (std::int32_t ix = 0; ix < 6; ++ix)
    {
      const bool inside = ix >= 2 && ix < 4 && iy >= 2 && iy < 4;
      EXPECT_EQ(layer.at(ix, iy), !inside ? -1 : iy == 2 ? 1 : 0) << ix << " " << iy;
    }
}

TEST(ObstacleLayer, BadHeightsGetAnError)
{
  const World world = floorWith("");
  const auto errorOf = [&](double zMin, double zMax)
  {
    try
    {
      obstaclesIn(world, zMin, zMax);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(errorOf(0, 1), "");
  EXPECT_EQ(errorOf(1, 1), "zMax = 1 is not valid: it must be a finite height > zMin [m]");
  EXPECT_EQ(errorOf(std::nan(""), 1), "zMin = nan is not valid: it must be a finite height [m]");
  EXPECT_EQ(errorOf(0, std::numeric_limits<double>::infinity()),
            "zMax = inf is not valid: it must be a finite height > zMin [m]");
}

// --- no thin leg slips through

/** Legs of 2.5 cm at random places, in cells of 5 cm: each marks exactly the cells that it is in.
 */
TEST(ObstacleLayer, ThinLegsAreInTheCellsThatTheyStandIn)
{
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  std::uniform_int_distribution<int> place(1000, 9000);  // [0.1 mm]
  constexpr int kCell = 500, kLeg = 250;                 // likewise
  for (int i = 0; i < 300; ++i)
  {
    const int x = place(random), y = place(random);
    const auto text = [](int tenths) { return std::to_string(tenths * 1e-4); };
    const World world = floorWith("[box.leg]\nmin = " + text(x) + " " + text(y) +
                                  " 0\nmax = " + text(x + kLeg) + " " + text(y + kLeg) + " 0.4\n");
    Cells right;
    for (int ky = y / kCell; ky * kCell < y + kLeg; ++ky)
      for (int kx = x / kCell; kx * kCell < x + kLeg; ++kx) right.emplace_back(kx, ky);
    const auto layer = obstacleLayer(world, frameOf(world, 0.05), 0.05, 1.5, 1);
    ASSERT_EQ(cellsWith(layer, 1), right)
        << "seed " << kSeed << ", leg " << i << " at " << text(x) << " " << text(y);
  }
}

// --- against the slow twin

/** Says the same by asking at each point of the lattice, in each layer of 0.1 m, what is solid. */
Layer<float> twinOf(const RandomBodies& bodies, const World& world, const grid::GridFrame& frame,
                    int zMin, int zMax)
{
  const auto solidBetween = [&](double x, double y, int low, int high)  // [0.1 m]
  {
    for (int z = low; z < high; ++z)
      if (bodies.isSolid(x, y, (z + 0.5) * 0.1)) return true;
    return false;
  };
  Layer<float> layer(frame, 0);
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
    {
      const auto place = [&](std::int32_t key, double step, double min, double max)
      { return std::clamp((key + step) * frame.resolution, min, max); };
      const auto x = [&](double step)
      { return place(frame.x0 + ix, step, world.min().x, world.max().x); };
      const auto y = [&](double step)
      { return place(frame.y0 + iy, step, world.min().y, world.max().y); };
      bool hit = false;
      const double hair = 1e-6 / frame.resolution;
      for (int j = 0; j <= 8; ++j)
        for (int i = 0; i <= 8; ++i)
          hit = hit || solidBetween(x(std::clamp(i / 8.0, hair, 1 - hair)),
                                    y(std::clamp(j / 8.0, hair, 1 - hair)), zMin, zMax);
      const bool ground = solidBetween(x(0.5), y(0.5), -100, zMin);
      layer.at(ix, iy) = hit ? 1.0f : ground ? 0.0f : -1.0f;
    }
  return layer;
}

TEST(ObstacleLayer, AgreesWithTheSlowTwin)
{
  std::size_t counts[3] = {};
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomBodies bodies(seed);
    const World world = worldOf("[world]\nbounds = 0 0 -0.5 2 2 2.5\n" + bodies.text());
    const int zMin = static_cast<int>(seed % 9) - 3, zMax = zMin + 1 + static_cast<int>(seed % 7);
    const auto frame = frameOf(world, 0.25);
    const auto layer = obstacleLayer(world, frame, 0.1 * zMin, 0.1 * zMax, 1);
    ASSERT_EQ(layer.cells(), twinOf(bodies, world, frame, zMin, zMax).cells());
    for (const float cell : layer.cells()) ++counts[static_cast<int>(cell) + 1];
  }
  for (const std::size_t count : counts) EXPECT_GT(count, 100u);  // something of everything
}

TEST(ObstacleLayer, AllThreadsGiveTheSame)
{
  const World world = worldOf(
      "[world]\nbounds = -20 -20 -5 20 20 5\n[heightField.a]\nmin = -20 -20\nmax = 20 20\n"
      "cell = 0.5\nsolid = below\namplitude = 2\nwavelength = 6\noctaves = 2\n"
      "[sphere.b]\ncentre = 0 0 0\nradius = 3\n[box.c]\nmin = 4 4 -5\nmax = 7 5 9\nyaw = 20\n");
  const auto frame = frameOf(world, 0.25);
  const auto one = obstacleLayer(world, frame, 0.3, 1.5, 1);
  EXPECT_EQ(obstacleLayer(world, frame, 0.3, 1.5, 2).cells(), one.cells());
  EXPECT_EQ(obstacleLayer(world, frame, 0.3, 1.5, 0).cells(), one.cells());
}
}  // namespace
