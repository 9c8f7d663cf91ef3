#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "HandTerrain.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainLayers;
using terrain::TerrainMap;

float at(const grid::Layer<float>& layer, int kx, int ky)
{
  return layer.at(kx - layer.frame().x0, ky - layer.frame().y0);
}

TerrainLayers layersOf(TerrainMap& map)
{
  map.update();
  return map.layers();
}
}  // namespace

/** A plane of slope 0.4 with some noise, beside a single cell. */
TEST(TerrainLayers, HoldWhatPlanesAndCellsSay)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 7, 7, [](int x, int y) { return 0.02 * x + (x + y) % 2 * 0.01; });
  map.insertPoint(-2 * kCell, 0, 3, 0.25);
  const TerrainLayers layers = layersOf(map);
  ASSERT_EQ(map.planes().size(), 1u);
  EXPECT_EQ(layers.height.frame(), map.frame());
  EXPECT_EQ(layers.height.frame().x0, -2);
  EXPECT_EQ(layers.height.frame().shift, -0.5);
  EXPECT_NEAR(at(layers.height, 3, 3), 0.065, 1e-3);
  EXPECT_NEAR(at(layers.sigma, 3, 3), 0.005, 1e-4) << "the plane's rms";
  EXPECT_EQ(at(layers.plane, 3, 3), 0);
  EXPECT_NEAR(at(layers.slope, 3, 3), 0.4, 1e-2);
  EXPECT_NEAR(at(layers.leafSide, 3, 3), 8 * kCell, 1e-6);

  EXPECT_EQ(at(layers.height, -2, 0), 3);
  EXPECT_NEAR(at(layers.sigma, -2, 0), 0.25, 1e-4) << "that of the cell's height";
  EXPECT_TRUE(std::isnan(at(layers.plane, -2, 0)));
  EXPECT_TRUE(std::isnan(at(layers.slope, -2, 0)));
  EXPECT_NEAR(at(layers.leafSide, -2, 0), kCell, 1e-6);

  for (const auto* layer :
       {&layers.height, &layers.sigma, &layers.plane, &layers.leafSide, &layers.slope})
    EXPECT_TRUE(std::isnan(at(*layer, -1, 3)));
  EXPECT_EQ(at(layers.traversability, -1, 3), -1);
}

TEST(TerrainLayers, SteepPlanesAreOccupied)
{
  terrain::TerrainParams params;
  params.maxSlope = 0.5;
  params.maxStep = 10;
  for (const double slope : {0.49, 0.51})
  {
    TerrainMap map(kCell, params);
    putAll(map, 0, 0, 7, 7, [slope](int x, int) { return slope * kCell * x; });
    EXPECT_EQ(at(layersOf(map).traversability, 4, 4), slope > 0.5 ? 1 : 0) << slope;
  }
}

/** On both sides of a step and diagonally, but not a cell further. */
TEST(TerrainLayers, CellsBesideAStepAreOccupied)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 19, 9, [](int x, int y) { return x >= 10 && y >= 5 ? 0.21 : 0; });
  const TerrainLayers layers = layersOf(map);
  EXPECT_EQ(at(layers.traversability, 9, 7), 1);
  EXPECT_EQ(at(layers.traversability, 10, 7), 1);
  EXPECT_EQ(at(layers.traversability, 9, 4), 1) << "diagonally";
  EXPECT_EQ(at(layers.traversability, 8, 7), 0);
  EXPECT_EQ(at(layers.traversability, 11, 7), 0);
  EXPECT_EQ(at(layers.traversability, 8, 3), 0);
}

/** A post: its 8 neighbours and itself, nothing else. */
TEST(TerrainLayers, CellsAroundAHigherOneAreOccupied)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 10, 10, [](int x, int y) { return x == 5 && y == 5 ? 1 : 0; });
  const TerrainLayers layers = layersOf(map);
  for (int y = 0; y <= 10; ++y)
    for (int x = 0; x <= 10; ++x)
      EXPECT_EQ(at(layers.traversability, x, y), std::abs(x - 5) <= 1 && std::abs(y - 5) <= 1)
          << x << ", " << y;
}

TEST(TerrainLayers, AStepOfMaxStepIsFree)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 19, 9, [](int x, int) { return x >= 10 ? 0.1875 : 0; });
  EXPECT_EQ(at(layersOf(map).traversability, 9, 4), 0);
}

TEST(TerrainLayers, OfAnEmptyMapAreEmpty)
{
  TerrainMap map(kCell);
  EXPECT_TRUE(layersOf(map).height.frame().empty());
}

namespace
{
/** Of cells at that height, and others 4 rows of unseen cells (0.25 m) to the south of them. */
TerrainLayers besideUnseen(double own, double beyond, int firstBeyond = -5)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 19, 9, own);
  putAll(map, 0, firstBeyond - 9, 19, firstBeyond, beyond);
  return layersOf(map);
}

/** What a scan makes of a level step in the middle of a cell, with noise along and across. */
TerrainLayers noisyStep(double rise, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.02);
  std::uniform_real_distribution<double> along(-1, 1), across(0, 0.6), upright(0, rise);
  TerrainMap map(kCell);
  const auto put = [&](double x, double y, double z)
  { map.insertPoint(x + noise(random), y + noise(random), z + noise(random), 0.02); };
  for (int i = 0; i < 20000; ++i)
  {
    const double x = along(random);
    put(x, across(random), x > 0 ? rise : 0);
  }
  for (int i = 0; i < 2000; ++i) put(0, across(random), upright(random));
  return layersOf(map);
}

/** Whether a robot of one cell gets from the first column to the last, diagonally as well. */
bool isWayAcross(const grid::Layer<float>& traversability)
{
  const grid::GridFrame& frame = traversability.frame();
  std::vector<std::pair<int, int>> stack;
  grid::Layer<float> left = traversability;
  const auto enter = [&](int x, int y)
  {
    if (x < 0 || y < 0 || x >= frame.width || y >= frame.height || left.at(x, y) != 0) return;
    left.at(x, y) = 1;
    stack.emplace_back(x, y);
  };
  for (int y = 0; y < frame.height; ++y) enter(0, y);
  while (!stack.empty())
  {
    const auto [x, y] = stack.back();
    stack.pop_back();
    if (x == frame.width - 1) return true;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) enter(x + dx, y + dy);
  }
  return false;
}
}  // namespace

TEST(TerrainLayers, AnEdgeWhoseFootNobodySawIsOccupied)
{
  const TerrainLayers layers = besideUnseen(0, -0.3);
  for (int x = 0; x < 20; ++x)
  {
    EXPECT_EQ(at(layers.traversability, x, 0), 1) << x;
    EXPECT_EQ(at(layers.traversability, x, 1), 0) << x;
    EXPECT_EQ(at(layers.traversability, x, -1), -1) << x;
    EXPECT_EQ(at(layers.traversability, x, -5), 0) << "at the foot nobody falls";
  }
}

TEST(TerrainLayers, AGapToGroundThatIsHardlyLowerIsNoEdge)
{
  EXPECT_EQ(at(besideUnseen(0, -0.18).traversability, 9, 0), 0);
  EXPECT_EQ(at(besideUnseen(0, -0.3, -60).traversability, 9, 0), 0) << "too far away to tell";
}

TEST(TerrainLayers, ARampThatGoesOnBehindAGapIsNoEdge)
{
  TerrainMap map(kCell);
  const auto ramp = [](int, int y) { return 0.4 * kCell * y; };
  putAll(map, 0, 0, 19, 9, ramp);
  putAll(map, 0, -30, 19, -15, ramp);
  const TerrainLayers layers = layersOf(map);
  for (int x = 0; x < 20; ++x) EXPECT_EQ(at(layers.traversability, x, 0), 0) << x;
}

/** Cells that noise has put beyond an edge are as much a trap as the edge. */
TEST(TerrainLayers, StrayCellsBeyondAnEdgeAreOccupied)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 19, 9, 0);
  putAll(map, 0, -14, 19, -6, -0.4);
  put(map, 9, -1, -0.06);
  const TerrainLayers layers = layersOf(map);
  EXPECT_EQ(at(layers.traversability, 9, -1), 1);
  EXPECT_EQ(at(layers.traversability, 9, 0), 1);
}

TEST(TerrainLayers, AStepInMidCellIsOccupiedAllAlong)
{
  for (const double rise : {0.3, -0.3})
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
      const TerrainLayers layers = noisyStep(rise, seed);
      EXPECT_FALSE(isWayAcross(layers.traversability)) << "seed " << seed << ", rise " << rise;
      for (int y = 1; y <= 11; ++y)
        for (const int x : {-10, 10}) EXPECT_EQ(at(layers.traversability, x, y), 0) << seed;
    }
}

/** Of a table most beams see the floor below it. */
TEST(TerrainLayers, CellsWithAPointFarAboveTheirHeightAreOccupied)
{
  TerrainMap map(kCell);
  for (int i = 0; i < 50; ++i) putAll(map, 0, 0, 19, 9, 0);
  put(map, 9, 4, 0.75);
  put(map, 4, 4, 0.15);
  const TerrainLayers layers = layersOf(map);
  ASSERT_NEAR(at(layers.height, 9, 4), 0, 0.02);
  EXPECT_EQ(at(layers.traversability, 9, 4), 1);
  EXPECT_EQ(at(layers.traversability, 10, 4), 0);
  EXPECT_EQ(at(layers.traversability, 4, 4), 0) << "less than maxStep";
}
