#include <gtest/gtest.h>

#include <cmath>

#include "HandTerrain.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainMap;

terrain::TerrainParams windowOf(double side)
{
  terrain::TerrainParams params;
  params.localWindow = side;
  return params;
}

/** A scan of a floor around a robot at (x, y), 3 m to each side; sensor in the map's origin. */
HandScan floorAround(double x, double y)
{
  HandScan hand;
  hand.robotPose = mrpt::poses::CPose3D(x, y, 0, 0, 0, 0);
  const auto kx = static_cast<int>(std::lround(x / kCell)),
             ky = static_cast<int>(std::lround(y / kCell));
  for (int iy = ky - 60; iy <= ky + 60; ++iy)
    for (int ix = kx - 60; ix <= kx + 60; ++ix) hand.add(ix * kCell, iy * kCell, 0);
  return hand;
}

HandScan nothingFrom(double x, double y)
{
  HandScan hand;
  hand.robotPose = mrpt::poses::CPose3D(x, y, 0, 0, 0, 0);
  return hand;
}
}  // namespace

TEST(LocalWindow, HoldsWholeCellsAroundTheRobot)
{
  TerrainMap map(kCell, windowOf(2));
  const auto inserted = map.insert(floorAround(0, 0).scan(), {});
  EXPECT_EQ(map.cells(), 41u * 41u);
  EXPECT_EQ(inserted.inserted, 41u * 41u);
  EXPECT_EQ(inserted.outside, 121u * 121u - 41u * 41u);
  EXPECT_TRUE(map.cell(-20, 20));
  EXPECT_FALSE(map.cell(-21, 20));
  const auto frame = map.frame();
  EXPECT_EQ(frame.x0, -20);
  EXPECT_EQ(frame.xEnd(), 21);
}

TEST(LocalWindow, ForgetsWhatItLeaves)
{
  TerrainMap map(kCell, windowOf(2));
  map.insert(floorAround(0, 0).scan(), {});
  map.update();
  map.insert(nothingFrom(10 * kCell, -3 * kCell).scan(), {});
  EXPECT_EQ(map.cells(), 31u * 38u);
  EXPECT_FALSE(map.cell(-11, 0));
  EXPECT_FALSE(map.cell(0, 18));
  map.update();
  ASSERT_EQ(map.planes().size(), 1u);
  EXPECT_EQ(map.planes()[0].cells, 31 * 38);
  EXPECT_FALSE(map.at(-11 * kCell, 0));
  EXPECT_TRUE(map.at(-10 * kCell, 0));
  EXPECT_EQ(map.frame().x0, -10);
  map.insert(nothingFrom(0, 0).scan(), {});
  EXPECT_EQ(map.cells(), 31u * 38u) << "what was left is forgotten for good";
}

TEST(LocalWindow, FarAwayEverythingIsForgotten)
{
  TerrainMap map(kCell, windowOf(2));
  map.insert(floorAround(0, 0).scan(), {});
  map.update();
  map.insert(nothingFrom(1000, 1000).scan(), {});
  EXPECT_EQ(map.cells(), 0u);
  map.update();
  EXPECT_TRUE(map.planes().empty());
  EXPECT_EQ(map.leaves(), 0u);
  EXPECT_TRUE(map.frame().empty());
}

/** Forgotten cells leave their planes' moments. */
TEST(LocalWindow, PlanesKnowOnlyTheCellsThatAreLeft)
{
  TerrainMap map(kCell, windowOf(2));
  HandScan hand;
  // two slopes that are one plane within the tolerance
  for (int y = -20; y <= 20; ++y)
    for (int x = -20; x <= 20; ++x) hand.add(x * kCell, y * kCell, x < 0 ? 0 : 0.001 * x);
  map.insert(hand.scan(), {});
  map.update();
  ASSERT_EQ(map.planes().size(), 1u);
  EXPECT_GT(map.planes()[0].rms, 1e-3);
  map.insert(nothingFrom(20 * kCell, 0).scan(), {});
  map.update();
  ASSERT_EQ(map.planes().size(), 1u);
  EXPECT_EQ(map.planes()[0].cells, 21 * 41);
  EXPECT_NEAR(map.planes()[0].slopeX, 0.02, 1e-4);
  EXPECT_LT(map.planes()[0].rms, 5e-5);
}

/** What a narrow bridge connected is two planes when the bridge is forgotten. */
TEST(LocalWindow, PlanesThatAreNoLongerConnectedAreTwo)
{
  TerrainMap map(kCell, windowOf(4));
  HandScan hand;
  for (int y = -10; y <= 10; ++y)
    for (int x = -40; x <= 10; ++x)
      if (x < -30 || y < -3 || y > 3) hand.add(x * kCell, y * kCell, 0);
  map.insert(hand.scan(), {});
  map.update();
  ASSERT_EQ(map.planes().size(), 1u);
  map.insert(nothingFrom(15 * kCell, 0).scan(), {});
  map.update();
  ASSERT_EQ(map.planes().size(), 2u);
  EXPECT_EQ(map.planes()[0].cells, 36 * 7);
  EXPECT_EQ(map.planes()[1].cells, 36 * 7);
}

/** A drive that never comes back: the map is that of the points inside. */
TEST(LocalWindow, EqualsAMapOfWhatIsInside)
{
  const auto heightAt = [](int x, int y) {
    return x % 50 < 25 ? 0 : y > 0 ? 0.3 : 0.004 * (x % 50);
  };
  TerrainMap rolling(kCell, windowOf(3));
  for (int step = 0; step < 40; ++step)
  {
    const int robot = 7 * step;
    HandScan hand = nothingFrom(robot * kCell, 0);
    for (int y = -30; y <= 30; ++y)
      for (int x = robot - 30; x <= robot + 30; ++x) hand.add(x * kCell, y * kCell, heightAt(x, y));
    rolling.insert(hand.scan(), {});
    rolling.update();
    TerrainMap inside(kCell);
    inside.insert(hand.scan(), {});
    inside.update();
    ASSERT_EQ(rolling.cells(), inside.cells()) << "step " << step;
    ASSERT_EQ(rolling.planes().size(), inside.planes().size()) << "step " << step;
    EXPECT_EQ(rolling.leaves(), inside.leaves()) << "step " << step;
    for (int y = -30; y <= 30; ++y)
      for (int x = robot - 30; x <= robot + 30; ++x)
        ASSERT_EQ(planeAt(rolling, x, y), planeAt(inside, x, y))
            << "step " << step << ", cell (" << x << ", " << y << ")";
  }
}

TEST(LocalWindow, MemoryStaysWhileTheRobotDrives)
{
  TerrainMap map(kCell, windowOf(4));
  std::size_t early = 0, late = 0;
  for (int step = 0; step < 200; ++step)
  {
    map.insert(floorAround(0.5 * step, 0).scan(), {});
    map.update();
    (step < 60 ? early : late) = std::max(step < 60 ? early : late, map.memory());
  }
  EXPECT_LE(static_cast<double>(late), 1.1 * static_cast<double>(early));
}

TEST(LocalWindow, CanBeAskedBeforeTheUpdate)
{
  TerrainMap map(kCell, windowOf(4));
  map.insert(floorAround(0, 0).scan(), {});
  map.update();
  map.insert(nothingFrom(2.5, 0).scan(), {});
  const auto layers = map.layers();
  EXPECT_EQ(layers.height.frame(), map.frame());
  EXPECT_FALSE(map.at(-1.5, 0));
  EXPECT_TRUE(map.at(1.5, 0));
  for (const auto& leaf : map.leavesIn(-10, -10, 10, 10))
    EXPECT_TRUE(map.frame().containsKey(leaf.x, leaf.y));
}

TEST(LocalWindow, HoldsForSinglePoints)
{
  TerrainMap map(kCell, windowOf(4));
  map.insert(floorAround(0, 0).scan(), {});
  const auto cells = map.cells();
  map.insertPoint(50, 0, 0, 0.01);
  EXPECT_EQ(map.cells(), cells);
}
