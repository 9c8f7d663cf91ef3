#include <gtest/gtest.h>

#include <cmath>

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
