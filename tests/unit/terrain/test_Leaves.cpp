#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "HandTerrain.h"
#include "oracle/TerrainOracle.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainLeaf;
using terrain::TerrainMap;

std::vector<TerrainLeaf> allLeaves(const TerrainMap& map)
{
  return map.leavesIn(-1e9, -1e9, 1e9, 1e9);
}

int below(std::mt19937& random, unsigned end) { return static_cast<int>(random() % end); }

/** Patches of two heights with rubble and holes. */
TerrainMap patchy(unsigned seed)
{
  std::mt19937 random(seed);
  TerrainMap map(kCell);
  const int x0 = below(random, 200) - 100, y0 = below(random, 200) - 100;
  for (int y = y0; y < y0 + 110; ++y)
    for (int x = x0; x < x0 + 130; ++x)
    {
      if (below(random, 200) == 0) continue;
      const bool isHigh = x > x0 + 70 && y > y0 + 20;
      put(map, x, y, below(random, 300) == 0 ? 5 + 0.1 * below(random, 9) : isHigh ? 0.5 : 0);
    }
  map.update();
  return map;
}
}  // namespace

/** 4 × 4 from (0, 0): one leaf; a row and a column more are leaves of one cell. */
TEST(Leaves, AreAlignedSquares)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 4, 4, 0);
  map.update();
  const auto leaves = allLeaves(map);
  ASSERT_EQ(leaves.size(), 10u);
  EXPECT_EQ(map.leaves(), 10u);
  EXPECT_EQ(leaves[0].x, 0);
  EXPECT_EQ(leaves[0].y, 0);
  EXPECT_EQ(leaves[0].side, 4);
  for (std::size_t i = 1; i < leaves.size(); ++i) EXPECT_EQ(leaves[i].side, 1);
}

TEST(Leaves, OfNegativeKeysAreAlignedAsOthers)
{
  TerrainMap map(kCell);
  putAll(map, -4, -4, -1, -1, 0);
  map.update();
  ASSERT_EQ(map.leaves(), 1u);
  EXPECT_EQ(allLeaves(map)[0].x, -4);
  TerrainMap across(kCell);
  putAll(across, -2, -2, 1, 1, 0);
  across.update();
  EXPECT_EQ(across.leaves(), 4u);
}

/** Larger than a tile of 32 cells. */
TEST(Leaves, GrowAsLargeAsTheirPlane)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 127, 127, 1);
  putAll(map, 128, 0, 191, 63, 1);
  map.update();
  const auto leaves = allLeaves(map);
  ASSERT_EQ(leaves.size(), 2u);
  EXPECT_EQ(leaves[0].side, 128);
  EXPECT_EQ(leaves[1].side, 64);
  EXPECT_EQ(leaves[1].x, 128);
  EXPECT_EQ(map.at(100 * kCell, 90 * kCell)->leafSide, 128);
  EXPECT_EQ(map.at(130 * kCell, 1 * kCell)->leafSide, 64);
}

/** One of the 16 tiles is another plane. */
TEST(Leaves, OfSeveralTilesLieInOnePlane)
{
  for (const int other : {0, 1, 2, 3})
  {
    TerrainMap map(kCell);
    const int x0 = 64 + 32 * (other % 2), y0 = 64 + 32 * (other / 2);
    putAll(map, 0, 0, 127, 127,
           [&](int x, int y) { return x >= x0 && x < x0 + 32 && y >= y0 && y < y0 + 32 ? 1 : 0; });
    map.update();
    EXPECT_EQ(map.planes().size(), 2u);
    EXPECT_EQ(map.leaves(), 7u) << "three of 64 cells and four of 32";
    const auto leaves = allLeaves(map);
    const auto wanted = oracle::leavesOf(oracle::planesOfCells(map));
    ASSERT_EQ(leaves.size(), wanted.size());
    for (std::size_t i = 0; i < leaves.size(); ++i)
      EXPECT_TRUE((oracle::TerrainSquare{leaves[i].x, leaves[i].y, leaves[i].side,
                                         leaves[i].plane} == wanted[i]));
  }
}

TEST(Leaves, CellsWithoutAPlaneHaveTheirOwnHeight)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 1, 1, 0.25);  // too few
  map.update();
  const auto leaves = allLeaves(map);
  ASSERT_EQ(leaves.size(), 4u);
  for (const TerrainLeaf& leaf : leaves)
  {
    EXPECT_EQ(leaf.side, 1);
    EXPECT_EQ(leaf.plane, -1);
    EXPECT_EQ(leaf.height, 0.25);
  }
}

/** The height of a leaf is that of its plane in its middle. */
TEST(Leaves, HeightIsThatOfThePlaneInTheMiddle)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 7, 7, [](int x, int y) { return 0.02 * x - 0.01 * y; });
  map.update();
  const auto leaves = allLeaves(map);
  ASSERT_EQ(leaves.size(), 1u);
  EXPECT_NEAR(leaves[0].height, 0.02 * 3.5 - 0.01 * 3.5, 1e-4);
}

TEST(Leaves, CoverEachKnownCellOnce)
{
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TerrainMap map = patchy(seed);
    const auto leaves = allLeaves(map);
    const auto wanted = oracle::leavesOf(oracle::planesOfCells(map));
    ASSERT_EQ(leaves.size(), wanted.size());
    EXPECT_EQ(map.leaves(), wanted.size());
    std::size_t cells = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      cells += static_cast<std::size_t>(leaves[i].side) * static_cast<std::size_t>(leaves[i].side);
      EXPECT_TRUE((oracle::TerrainSquare{leaves[i].x, leaves[i].y, leaves[i].side,
                                         leaves[i].plane} == wanted[i]))
          << "leaf " << i;
    }
    EXPECT_EQ(cells, map.cells());
  }
}

TEST(Leaves, InABoxAreThoseThatReachIntoIt)
{
  const TerrainMap map = patchy(77);
  const auto all = allLeaves(map);
  std::mt19937 random(3);
  const auto frame = map.frame();
  for (int i = 0; i < 200; ++i)
  {
    const double x = frame.xMin() - 1 + 0.01 * below(random, 1000),
                 y = frame.yMin() - 1 + 0.01 * below(random, 900),
                 width = 0.01 * below(random, 300), height = 0.01 * below(random, 300);
    std::vector<std::tuple<int, int, int>> wanted, found;
    for (const TerrainLeaf& leaf : all)
      if (leaf.x <= map.keyOf(x + width) && leaf.x + leaf.side > map.keyOf(x) &&
          leaf.y <= map.keyOf(y + height) && leaf.y + leaf.side > map.keyOf(y))
        wanted.emplace_back(leaf.x, leaf.y, leaf.side);
    for (const TerrainLeaf& leaf : map.leavesIn(x, y, x + width, y + height))
      found.emplace_back(leaf.x, leaf.y, leaf.side);
    EXPECT_TRUE(found == wanted) << "box " << i;
  }
}

TEST(Leaves, AnEmptyBoxHasNone)
{
  const TerrainMap map = patchy(78);
  EXPECT_TRUE(map.leavesIn(1e6, 1e6, 1e6 + 1, 1e6 + 1).empty());
  EXPECT_TRUE(map.leavesIn(1, 1, 0, 0).empty());
  EXPECT_TRUE(TerrainMap(kCell).leavesIn(-1e9, -1e9, 1e9, 1e9).empty());
}

TEST(Leaves, AnswersAtAPlaceAreThoseOfTheLeafThere)
{
  const TerrainMap map = patchy(79);
  for (const TerrainLeaf& leaf : allLeaves(map))
    for (const int corner : {0, leaf.side - 1})
    {
      const double x = (leaf.x + corner) * kCell, y = (leaf.y + corner) * kCell;
      const auto point = map.at(x, y);
      ASSERT_TRUE(point);
      EXPECT_EQ(point->leafSide, leaf.side);
      EXPECT_EQ(point->plane, leaf.plane);
      const double wanted = leaf.plane < 0
                                ? leaf.height
                                : map.planes()[static_cast<std::size_t>(leaf.plane)].heightAt(x, y);
      EXPECT_DOUBLE_EQ(point->height, wanted);
    }
}
