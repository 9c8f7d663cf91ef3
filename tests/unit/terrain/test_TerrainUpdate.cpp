// Planes follow the cells that change.
#include <gtest/gtest.h>

#include <random>

#include "HandTerrain.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainMap;
using terrain::TerrainParams;
}  // namespace

TEST(TerrainUpdate, ACellThatLeavesItsPlaneHasItsOwnHeight)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 9, 9, 0);
  map.update();
  map.insertPoint(4 * kCell, 4 * kCell, 1, 0.01);
  map.update();
  EXPECT_EQ(planeAt(map, 4, 4), -1);
  EXPECT_EQ(map.planes()[0].cells, 99);
  for (int i = 0; i < 100; ++i) put(map, 4, 4, 0);  // mean 1/102 m
  map.update();
  EXPECT_EQ(planeAt(map, 4, 4), 0);
}

TEST(TerrainUpdate, PlanesThatComeToTouchMerge)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 5, 9, 0);
  putAll(map, 8, 0, 15, 9, 0.01);
  map.update();
  EXPECT_EQ(map.planes().size(), 2u);
  putAll(map, 6, 0, 7, 9, 0.005);
  map.update();
  ASSERT_EQ(map.planes().size(), 1u);
  EXPECT_EQ(map.planes()[0].cells, 160);
}

TEST(TerrainUpdate, ACutPlaneIsTwo)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 15, 9, 0);
  map.update();
  for (int i = 0; i < 50; ++i) putAll(map, 7, 0, 7, 9, 2);
  map.update();
  ASSERT_EQ(map.planes().size(), 2u);
  EXPECT_EQ(map.planes()[0].cells, 70);
  EXPECT_EQ(map.planes()[1].cells, 80);
  EXPECT_EQ(planeAt(map, 7, 3), -1);
}

/** Small plates amid rubble, of which the last cell comes later. That cell alone is not enough of a
 * seed: most of the cells around it are rubble. */
TEST(TerrainUpdate, CellsBesideAChangedOneAreSeedsAgain)
{
  TerrainParams params;
  params.minPlaneCells = 16;
  const auto isPlate = [](int x, int y)
  { return x % 10 >= 3 && x % 10 < 7 && y % 10 >= 3 && y % 10 < 7; };
  const auto isLast = [](int x, int y) { return x % 10 == 3 && y % 10 == 3; };
  for (const bool isFloor : {false, true})
  {
    std::mt19937 random(1);
    TerrainMap map(kCell, params);
    if (isFloor) putAll(map, 100, 0, 120, 20, 0);
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 80; ++x)
      {
        const double rubble = 0.2 + 0.001 * static_cast<double>(random() % 2000);
        if (!isLast(x, y)) put(map, x, y, isPlate(x, y) ? 0 : rubble);
      }
    map.update();
    EXPECT_EQ(map.planes().size(), isFloor ? 1u : 0u);
    for (int y = 3; y < 80; y += 10)
      for (int x = 3; x < 80; x += 10) put(map, x, y, 0);
    map.update();
    EXPECT_GE(map.planes().size(), 10u) << "of 64; one from the changed cells alone";
  }
}
