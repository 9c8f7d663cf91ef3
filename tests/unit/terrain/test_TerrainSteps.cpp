#include <gtest/gtest.h>

#include <cmath>

#include "HandTerrain.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainMap;
using terrain::TerrainStep;

TerrainMap updated(TerrainMap map)
{
  map.update();
  return map;
}

/** A floor of 10 cells, then treads of that many cells and such rises, 20 cells wide; to the east.
 */
TerrainMap stairsEast(const std::vector<int>& treads, const std::vector<double>& rises)
{
  TerrainMap map(kCell);
  putAll(map, -10, 0, -1, 19, 0);
  int x = 0;
  double z = 0;
  for (std::size_t i = 0; i < treads.size(); ++i)
  {
    z += rises[i];
    putAll(map, x, 0, x + treads[i] - 1, 19, z);
    x += treads[i];
  }
  return updated(std::move(map));
}
}  // namespace

TEST(TerrainSteps, OfStairsToTheEast)
{
  const std::vector<int> treads{6, 5, 8};
  const std::vector<double> rises{0.17, 0.2, 0.1};
  const TerrainMap map = stairsEast(treads, rises);
  ASSERT_EQ(map.planes().size(), 4u);
  const auto steps = map.steps();
  ASSERT_EQ(steps.size(), 3u);
  double x = -0.5 * kCell;
  for (std::size_t i = 0; i < 3; ++i)
  {
    SCOPED_TRACE("step " + std::to_string(i));
    EXPECT_EQ(steps[i].lower, static_cast<int>(i));
    EXPECT_EQ(steps[i].upper, static_cast<int>(i) + 1);
    EXPECT_NEAR(steps[i].height, rises[i], 1e-4);
    EXPECT_NEAR(steps[i].depth, treads[i] * kCell, 1e-9);
    EXPECT_NEAR(steps[i].width, 20 * kCell, 1e-9);
    EXPECT_NEAR(steps[i].directionX, 1, 1e-9);
    EXPECT_NEAR(steps[i].directionY, 0, 1e-9);
    EXPECT_NEAR(steps[i].x, x, 1e-9);
    EXPECT_NEAR(steps[i].y, 9.5 * kCell, 1e-9);
    x += treads[i] * kCell;
  }
}

/** Down to the south: the upper planes have the higher keys, the direction is up. */
TEST(TerrainSteps, DirectionIsUpwards)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 11, 5, 0.2);
  putAll(map, 0, -6, 11, -1, 0.5);
  const auto steps = updated(std::move(map)).steps();
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].lower, 1);
  EXPECT_EQ(steps[0].upper, 0);
  EXPECT_NEAR(steps[0].directionX, 0, 1e-9);
  EXPECT_NEAR(steps[0].directionY, -1, 1e-9);
  EXPECT_NEAR(steps[0].height, 0.3, 1e-4);
}

/** A line of cells between two treads, as of a riser, which is no plane: a half to each. */
TEST(TerrainSteps, CellsOfARiserBelongToBothTreads)
{
  TerrainMap map(kCell);
  putAll(map, -10, 0, -1, 19, 0);
  putAll(map, 0, 0, 0, 19, 0.1);
  putAll(map, 1, 0, 6, 19, 0.2);
  putAll(map, 7, 0, 7, 19, 0.3);
  putAll(map, 8, 0, 13, 19, 0.4);
  const auto steps = updated(std::move(map)).steps();
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_NEAR(steps[0].height, 0.2, 1e-4);
  EXPECT_NEAR(steps[0].depth, 7 * kCell, 1e-9);
  EXPECT_NEAR(steps[0].x, 0, 1e-9);
  EXPECT_NEAR(steps[1].height, 0.2, 1e-4);
  EXPECT_NEAR(steps[1].depth, 6.5 * kCell, 1e-9) << "nothing is known behind the last tread";
}

TEST(TerrainSteps, AcrossUnknownCellsThereIsNone)
{
  TerrainMap map(kCell);
  putAll(map, -10, 0, -1, 19, 0);
  putAll(map, 1, 0, 10, 19, 0.2);
  EXPECT_TRUE(updated(std::move(map)).steps().empty());
}

/** 30° from the axes. */
TEST(TerrainSteps, OfRotatedStairs)
{
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  TerrainMap map(kCell);
  putAll(map, -40, -40, 40, 40,
         [&](int x, int y) { return 0.15 * std::floor((c * x + s * y) / 10 + 0.01); });
  map.update();
  const auto steps = map.steps();
  int checked = 0;
  for (const TerrainStep& step : steps)
  {
    if (step.width < 2) continue;  // at the corners
    ++checked;
    EXPECT_NEAR(step.height, 0.15, 5e-3);
    EXPECT_NEAR(step.depth, 10 * kCell, kCell);
    EXPECT_NEAR(step.directionX, c, 0.03);
    EXPECT_NEAR(step.directionY, s, 0.03);
    EXPECT_NEAR(std::hypot(step.directionX, step.directionY), 1, 1e-9);
  }
  EXPECT_GE(checked, 6);
}

TEST(TerrainSteps, TreadsOfOneHeightThatAreNotConnectedAreTwoPlanes)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 5, 5, 0.2);
  putAll(map, 6, 0, 11, 5, 0);
  putAll(map, 12, 0, 17, 5, 0.2);
  map.update();
  ASSERT_EQ(map.planes().size(), 3u);
  EXPECT_NE(planeAt(map, 0, 0), planeAt(map, 17, 0));
  EXPECT_EQ(map.steps().size(), 2u);
}

/** Where a ramp leaves its floor there is no step; at its top there is one. */
TEST(TerrainSteps, ARampMeetsItsFloorWithoutAStep)
{
  TerrainMap map(kCell);
  putAll(map, -10, 0, -1, 19, 0);
  putAll(map, 0, 0, 20, 19, [](int x, int) { return 0.02 * (x + 1); });
  putAll(map, 21, 0, 30, 19, 0.7);
  map.update();
  ASSERT_EQ(map.planes().size(), 3u);
  const auto steps = map.steps();
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_NEAR(steps[0].height, 0.7 - 0.43, 1e-3);  // half a cell beyond the ramp's last
  EXPECT_NEAR(steps[0].x, 20.5 * kCell, 1e-9);
}

/** A platform amid a floor: up from all sides. */
TEST(TerrainSteps, OntoAPlatformAmidAFloorIsAStep)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 29, 29,
         [](int x, int y) { return x >= 10 && x < 20 && y >= 10 && y < 20 ? 0.3 : 0; });
  map.update();
  ASSERT_EQ(map.planes().size(), 2u);
  const auto steps = map.steps();
  ASSERT_FALSE(steps.empty());
  for (const TerrainStep& step : steps)
  {
    EXPECT_EQ(step.lower, 0);
    EXPECT_EQ(step.upper, 1);
    EXPECT_NEAR(step.height, 0.3, 1e-4);
    EXPECT_NEAR(step.depth, 10 * kCell, 1e-9);
    EXPECT_NEAR(step.width, 10 * kCell, 1e-9);
  }
}

TEST(TerrainSteps, ThereAreNoneWithoutPlanes)
{
  EXPECT_TRUE(TerrainMap(kCell).steps().empty());
  TerrainMap map(kCell);
  put(map, 0, 0, 0);
  put(map, 1, 0, 1);
  EXPECT_TRUE(updated(std::move(map)).steps().empty());
}

/** Noise draws the first and last rows of treads towards what lies beyond, within the tolerance. */
TEST(TerrainSteps, HeightsAreThoseOfTheInnerCells)
{
  TerrainMap map(0.02);
  putAll(map, 0, 0, 15, 29, [](int x, int) { return x > 13 ? 0.015 : 0; });
  putAll(map, 16, 0, 31, 29, [](int x, int) { return x < 18 ? 0.185 : x > 29 ? 0.215 : 0.2; });
  putAll(map, 32, 0, 47, 29, [](int x, int) { return x < 34 ? 0.385 : 0.4; });
  map.update();
  ASSERT_EQ(map.planes().size(), 3u);
  const auto steps = map.steps();
  ASSERT_EQ(steps.size(), 2u);
  for (const TerrainStep& step : steps) EXPECT_NEAR(step.height, 0.2, 1e-3);
}

TEST(TerrainSteps, ASummitEndsInTheMiddleOfBothRisers)
{
  TerrainMap map(0.05);
  putAll(map, 0, 0, 9, 19, 0);
  putAll(map, 10, 0, 11, 19, [](int x, int y) { return x == 10 ? 0.1 : 0.15 + y % 2 * 0.07; });
  putAll(map, 12, 0, 21, 19, 0.3);
  putAll(map, 22, 0, 23, 19, [](int x, int y) { return x == 23 ? 0.1 : 0.15 + y % 2 * 0.07; });
  putAll(map, 24, 0, 33, 19, 0);
  map.update();
  const auto steps = map.steps();
  ASSERT_EQ(steps.size(), 2u);
  for (const TerrainStep& step : steps) EXPECT_NEAR(step.depth, 0.6, 1e-9);
}
