#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "../../oracle/LayeredTruth.h"
#include "RandomBodies.h"
#include "WorldText.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;
using mrpt_mapconv::test::RandomBodies;
using mrpt_mapconv::test::worldOf;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/** What the layers hold in a cell. */
struct Cell
{
  float floor, ceiling, slope, aerial, ground;
};

bool same(float a, float b)
{
  return (std::isnan(a) && std::isnan(b)) || a == b || std::abs(a - b) < 1e-6f;
}

/** The cell that holds a place [m]. */
Cell cellAt(const freespace::Layers& layers, double x, double y)
{
  const auto& frame = layers.frame();
  const auto i = frame.indexOfKey(static_cast<int>(std::floor(x / frame.resolution)),
                                  static_cast<int>(std::floor(y / frame.resolution)));
  return {layers.floor.cells()[i], layers.ceiling.cells()[i], layers.slope.cells()[i],
          layers.aerial.cells()[i], layers.ground.cells()[i]};
}

void expectCell(const freespace::Layers& layers, double x, double y, const Cell& right)
{
  SCOPED_TRACE("at " + std::to_string(x) + " " + std::to_string(y));
  const Cell cell = cellAt(layers, x, y);
  EXPECT_PRED2(same, cell.floor, right.floor) << "floor";
  EXPECT_PRED2(same, cell.ceiling, right.ceiling) << "ceiling";
  EXPECT_PRED2(same, cell.slope, right.slope) << "slope";
  EXPECT_EQ(cell.aerial, right.aerial) << "aerial";
  EXPECT_EQ(cell.ground, right.ground) << "ground";
}

/** Bodies on a floor with its upper face at z = 0, looked at in x, y from 0 to 4 m. */
freespace::Layers layersOf(const std::string& bodies, const TruthParams& params = {},
                           double zMax = 5, double resolution = 0.1)
{
  const World world = worldOf("[world]\nbounds = 0 0 -0.1 4 4 " + std::to_string(zMax) +
                              "\n[box.floor]\nmin = 0 0 -0.5\nmax = 4 4 0\n" + bodies);
  return truthLayers(world, frameOf(world, resolution), params, 1);
}

constexpr Cell kOpenFloor = {0, kInfinity, 0, 0, 0};

// --- worked out by hand

TEST(Truth, OpenFloor)
{
  const auto layers = layersOf("");
  EXPECT_EQ(layers.frame().size(), 1600u);
  for (std::int32_t i = 0; i < 40; ++i) expectCell(layers, 0.1 * i + 0.05, 0.05, kOpenFloor);
}

TEST(Truth, UnderATable)
{
  const std::string table =
      "[box.top]\nmin = 1 1 0.7\nmax = 3 2 0.75\n[box.leg]\nmin = 1 1 0\nmax = 1.1 1.1 0.7\n";
  const auto layers = layersOf(table);
  expectCell(layers, 2.05, 1.55, {0.75f, kInfinity, 0, 0, 1});  // only above the top there is room
  expectCell(layers, 0.75, 1.55, kOpenFloor);
  // a lower robot finds room below; so does a flying one, from the floor to the open sky
  TruthParams low;
  low.robotHeight = low.minClearance = 0.7;
  expectCell(layersOf(table, low), 2.05, 1.55, kOpenFloor);
  // but beside the leg
  expectCell(layersOf(table, low), 1.15, 1.05, {0, kInfinity, 0, 0, 1});
}

TEST(Truth, OnAPlatform)
{
  const auto layers = layersOf("[box.platform]\nmin = 1 1 0\nmax = 3 3 0.6\n");
  expectCell(layers, 2.05, 2.05, {0.6f, kInfinity, 0, 0, 0});
  // its sides lie between cells: those at either side of one look at it
  expectCell(layers, 1.05, 2.05, {0.6f, kInfinity, 0, 0, 1});
  expectCell(layers, 0.95, 2.05, {0, kInfinity, 0, 0, 1});
  expectCell(layers, 0.85, 2.05, kOpenFloor);
}

TEST(Truth, WallsThatReachTheCeilingOrDoNot)
{
  const std::string roof = "[box.roof]\nmin = 0 0 2.6\nmax = 4 4 3\n";
  const std::string wall = "[box.wall]\nmin = 2.01 0 0\nmax = 2.19 4 ";
  const auto closed = layersOf(roof + wall + "2.6\n", {}, 2.8);
  expectCell(closed, 2.15, 1, {kNone, kNone, kNone, 1, 1});
  expectCell(closed, 2.25, 1, {0, 2.6f, 0, 0, 0});
  expectCell(closed, 1.95, 1, {0, 2.6f, 0, 0, 0});
  const auto room = layersOf(roof + wall + "1.6\n", {}, 2.8);  // just enough above it
  expectCell(room, 2.15, 1, {1.6f, 2.6f, 0, 0, 1});
  const auto tight = layersOf(roof + wall + "1.61\n", {}, 2.8);
  expectCell(tight, 2.15, 1, {kNone, kNone, kNone, 1, 1});
}

TEST(Truth, SeveralGapsAboveEachOther)
{
  const auto layers = layersOf(
      "[box.a]\nmin = 0 0 0.5\nmax = 4 4 1\n"    // 0.5 m below it
      "[box.b]\nmin = 0 0 2.2\nmax = 4 4 2.4\n"  // 1.2 m
      "[box.c]\nmin = 0 0 3.4\nmax = 4 4 3.5\n"  // 1 m
      "[box.d]\nmin = 0 0 4.4\nmax = 4 4 9\n");  // 0.9 m
  expectCell(layers, 2, 2, {1, 3.4f, 0, 0, 1});
}

TEST(Truth, RampsByTheirSlope)
{
  const auto rampTo = [](double height)
  {
    return layersOf("[ramp.a]\nmin = 1 1 0\nmax = 3 3 " + std::to_string(height) +
                    "\ndirection = +x\n");
  };
  expectCell(rampTo(0.4), 2.05, 2.05, {0.21f, kInfinity, 0.2f, 0, 0});
  expectCell(rampTo(1.2), 2.05, 2.05, {0.63f, kInfinity, 0.6f, 0, 1});
  expectCell(rampTo(1.0), 2.05, 2.05, {0.525f, kInfinity, 0.5f, 0, 0});  // exactly the limit
  expectCell(rampTo(0.4), 0.95, 2.05, kOpenFloor);                       // its foot is no step
  expectCell(rampTo(0.4), 3.05, 2.05, {0, kInfinity, 0, 0, 1});          // its head is
}

TEST(Truth, StepsByTheirHeight)
{
  const auto stepOf = [](double height)
  { return layersOf("[box.a]\nmin = 2.02 0 0\nmax = 4 4 " + std::to_string(height) + "\n"); };
  expectCell(stepOf(0.05), 2.05, 2, {0.05f, kInfinity, 0, 0, 0});
  expectCell(stepOf(0.10), 2.05, 2, {0.1f, kInfinity, 0, 0, 0});  // exactly the limit
  expectCell(stepOf(0.15), 2.05, 2, {0.15f, kInfinity, 0, 0, 1});
  expectCell(stepOf(0.15), 2.15, 2, {0.15f, kInfinity, 0, 0, 0});
  expectCell(stepOf(0.15), 1.95, 2, kOpenFloor);
}

TEST(Truth, ThinPostsAreSeenFromTheirCell)
{
  // thinner than a cell, away from its centre; the lattice has a point every 12.5 mm
  const auto layers =
      layersOf("[cylinder.post]\nbase = 2.025 2.025 0\nradius = 0.01\nheight = 2\n");
  expectCell(layers, 2.05, 2.05, {0, kInfinity, 0, 0, 1});
  expectCell(layers, 2.15, 2.05, kOpenFloor);
  expectCell(layers, 1.95, 2.05, kOpenFloor);
}

TEST(Truth, HolesAreJumpsAndHaveNoLayers)
{
  const World world = worldOf(
      "[world]\nbounds = 0 0 -1 4 4 5\n[box.a]\nmin = 0 0 -1\nmax = 1.96 4 0\n"
      "[box.b]\nmin = 2.55 0 -1\nmax = 4 4 0\n[box.deep]\nmin = 0 0 -9\nmax = 4 4 -8\n");
  const auto layers = truthLayers(world, frameOf(world, 0.1), {}, 1);
  expectCell(layers, 2.25, 2, {kNone, kNone, kNone, -1, -1});  // what is deeper does not count
  expectCell(layers, 1.95, 2, {0, kInfinity, 0, 0, 1});
  expectCell(layers, 1.85, 2, kOpenFloor);
}

TEST(Truth, WithinTheBoundsOnly)
{
  const std::string roof = "[box.roof]\nmin = 0 0 3\nmax = 4 4 3.5\n";
  expectCell(layersOf(roof, {}, 3.2), 2, 2, {0, 3, 0, 0, 0});  // nothing above the roof
  expectCell(layersOf(roof, {}, 3.5), 2, 2, {0, 3, 0, 0, 0});
  expectCell(layersOf(roof, {}, 3.6), 2, 2, {0, kInfinity, 0, 0, 0});
  expectCell(layersOf(roof, {}, 2.5), 2, 2, {0, 2.5f, 0, 0, 0});  // cut by the bounds
  expectCell(layersOf("", {}, 0.5), 2, 2, kOpenFloor);            // open sky is not
}

TEST(Truth, CellsBeyondTheBoundsAreUnknown)
{
  const World world =
      worldOf("[world]\nbounds = 0 0 -1 1 1 2\n[box.a]\nmin = -5 -5 -1\nmax = 5 5 0\n");
  const grid::GridFrame frame{0.5, -2, -2, 6, 6};
  const auto layers = truthLayers(world, frame, {}, 1);
  for (std::int32_t iy = 0; iy < 6; ++iy)
    for (std::int32_t ix = 0; ix < 6; ++ix)
    {
      const bool inside = ix >= 2 && ix < 4 && iy >= 2 && iy < 4;
      EXPECT_EQ(layers.ground.at(ix, iy), inside ? 0 : -1) << ix << " " << iy;
    }
}

TEST(Truth, FrameOfAWorld)
{
  const World world({-1, -0.31, 0}, {0.3, 0.61, 1});
  const auto frame = frameOf(world, 0.1);
  EXPECT_EQ(frame.x0, -10);
  EXPECT_EQ(frame.width, 13);  // 0.3 / 0.1 is a little less than 3 in floating point
  EXPECT_EQ(frame.y0, -4);
  EXPECT_EQ(frame.height, 11);
  EXPECT_THROW(frameOf(world, 0), std::invalid_argument);
  EXPECT_THROW(frameOf(world, -0.1), std::invalid_argument);
  EXPECT_THROW(frameOf(world, 1e-6), std::invalid_argument);
  EXPECT_THROW(frameOf(world, std::nan("")), std::invalid_argument);
  const World square({0, 0, 0}, {620, 620, 1}), strip({0, 0, 0}, {9000, 1, 1}),
      far({9e5, 9e5, 0}, {9e5 + 1, 9e5 + 1, 1});
  EXPECT_EQ(frameOf(square, 0.1).size(), 6200u * 6200u);
  EXPECT_THROW(frameOf(square, 0.095), std::invalid_argument) << "more than 4e7 cells";
  EXPECT_EQ(frameOf(strip, 0.1).width, 90000);
  EXPECT_THROW(frameOf(strip, 0.089), std::invalid_argument) << "more than 1e5 on a side";
  EXPECT_EQ(frameOf(far, 0.001).x0, 900000000);
  EXPECT_THROW(frameOf(far, 0.0005), std::invalid_argument) << "keys beyond 32 bits";
}

TEST(Truth, BadParametersGetAnError)
{
  const auto errorOf = [](TruthParams params)
  {
    try
    {
      params.check();
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(errorOf({}), "");
  EXPECT_EQ(errorOf({0, 1, 1, 1}),
            "minClearance = 0 is not valid: it must be a finite height > 0 m");
  EXPECT_EQ(errorOf({1, -1, 1, 1}),
            "robotHeight = -1 is not valid: it must be a finite height > 0 m");
  EXPECT_EQ(errorOf({1, 1, -1, 1}), "maxSlope = -1 is not valid: it must be a finite slope >= 0");
  EXPECT_EQ(errorOf({1, 1, 1, -1}), "maxStep = -1 is not valid: it must be a finite height >= 0 m");
  EXPECT_EQ(errorOf({1, 1, 1, 0}), "");
}

// --- against the slow twin

void expectSameLayers(const freespace::Layers& layers, const freespace::Layers& right)
{
  ASSERT_EQ(layers.frame(), right.frame());
  const auto all = layers.named(), allRight = right.named();
  for (std::size_t layer = 0; layer < all.size(); ++layer)
    for (std::size_t i = 0; i < layers.frame().size(); ++i)
      ASSERT_PRED2(same, all[layer].second->cells()[i], allRight[layer].second->cells()[i])
          << all[layer].first << " in cell " << i;
}

TEST(Truth, AgreesWithTheSlowTwin)
{
  std::size_t free = 0, occupied = 0, unknown = 0, groundFree = 0;
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomBodies bodies(seed);
    const std::string bounds = "[world]\nbounds = 0 0 -0.5 2 2 2.5\n";
    const World world = worldOf(bounds + bodies.text());
    TruthParams params;
    params.minClearance = 0.1 * (1 + seed % 9);
    params.robotHeight = 0.1 * (1 + seed % 7);
    params.maxStep = 0.1 * (seed % 3);
    const grid::GridFrame frame = frameOf(world, 0.25);
    const oracle::LayeredWorld twin{[&](double x, double y, double z)
                                    { return bodies.isSolid(x, y, z); },
                                    world.min(), world.max(), 0.1};
    const auto layers = truthLayers(world, frame, params, 1);
    ASSERT_NO_FATAL_FAILURE(expectSameLayers(layers, oracle::truthOf(twin, frame, params)));
    const auto counts = statistics(layers);
    free += counts.free;
    occupied += counts.occupied;
    unknown += counts.unknown;
    groundFree += counts.free - counts.steep;
  }
  // the worlds have something of everything
  for (const std::size_t count : {free, occupied, unknown, groundFree}) EXPECT_GT(count, 100u);
}

TEST(Truth, AllThreadsGiveTheSame)
{
  const World world = worldOf(
      "[world]\nbounds = -20 -20 -5 20 20 5\n[heightField.a]\nmin = -20 -20\nmax = 20 20\n"
      "cell = 0.5\nsolid = below\namplitude = 2\nwavelength = 6\noctaves = 2\n"
      "[sphere.b]\ncentre = 0 0 0\nradius = 3\n[box.c]\nmin = 4 4 -5\nmax = 7 5 9\nyaw = 20\n");
  const auto frame = frameOf(world, 0.25);
  const auto one = truthLayers(world, frame, {}, 1);
  expectSameLayers(truthLayers(world, frame, {}, 2), one);
  expectSameLayers(truthLayers(world, frame, {}, 0), one);
}
}  // namespace
