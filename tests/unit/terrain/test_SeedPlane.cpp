#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../mrpt_mapconv/src/terrain/SeedPlane.h"
#include "HandTiles.h"

namespace
{
using namespace mrpt_mapconv::terrain;
using mrpt_mapconv::test::putCell;

using HeightAt = std::function<std::int32_t(int, int)>;

void putSquare(TileMap& tiles, int x0, int y0, int side, const HeightAt& heightAt)
{
  for (int y = y0; y < y0 + side; ++y)
    for (int x = x0; x < x0 + side; ++x) putCell(tiles, x, y, heightAt(x, y));
}

/** d = 1000 units, as steep as 2000 units a cell. */
PlaneSearch search(std::int32_t window)
{
  PlaneSearch search;
  search.tolerance = 1000;
  search.mostSlope = 2000;
  search.window = window;
  search.hypotheses = 16;
  search.blockCells = 8;
  return search;
}
}  // namespace

TEST(SeedPlane, FindsThePlaneOfAWindow)
{
  for (const std::int32_t window : {2, 4, 10, 32})  // small ones are read in full, others drawn
  {
    TileMap tiles;
    putSquare(tiles, -40, -40, 80, [](int x, int y) { return 5000 + 300 * x - 700 * y; });
    SeedPlane seedPlane(search(window));
    for (const int key : {-40, -1, 0, 31, 39})
    {
      const auto plane = seedPlane.find(tiles.cell(key, -key / 2));
      ASSERT_TRUE(plane) << "window " << window << ", key " << key;
      EXPECT_NEAR(plane->slopeX, 300, 1e-2);
      EXPECT_NEAR(plane->slopeY, -700, 1e-2);
      EXPECT_DOUBLE_EQ(plane->at(key, -key / 2), 5000 + 300 * key - 700 * (-key / 2));
    }
  }
}

/** Of a step's two treads the one that holds the seed. */
TEST(SeedPlane, PrefersThePlaneOfMoreCells)
{
  TileMap tiles;
  putSquare(tiles, 0, 0, 30, [](int x, int) { return x < 12 ? 0 : 5000; });
  SeedPlane seedPlane(search(4));
  int level = 0;
  for (int y = 5; y < 25; ++y)
  {
    const auto plane = seedPlane.find(tiles.cell(10, y));
    ASSERT_TRUE(plane);
    level += std::abs(plane->slopeX) < 1 && std::abs(plane->slopeY) < 1 ? 1 : 0;
  }
  EXPECT_GE(level, 18);
}

TEST(SeedPlane, FindsNoneWhereCellsAreOnOneLine)
{
  TileMap row, column, two, one;
  for (int i = -20; i < 20; ++i)
  {
    putCell(row, i, 3, 0);
    putCell(column, 3, i, 0);
  }
  putCell(two, 3, 3, 0);
  putCell(two, 4, 3, 0);
  putCell(one, 3, 3, 0);
  SeedPlane seedPlane(search(4));
  for (TileMap* tiles : {&row, &column, &two, &one})
    EXPECT_FALSE(seedPlane.find(tiles->cell(3, 3)));
}

TEST(SeedPlane, FindsNoneThatIsTooSteep)
{
  TileMap tiles;
  putSquare(tiles, 0, 0, 20, [](int x, int) { return 2100 * x; });
  SeedPlane seedPlane(search(4));
  EXPECT_FALSE(seedPlane.find(tiles.cell(10, 10)));
}

TEST(SeedPlane, LooksOnlyAtCellsWithoutAPlane)
{
  TileMap tiles;
  putSquare(tiles, 0, 0, 20, [](int x, int y) { return x < 10 ? 0 : 400 * y; });
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 10; ++x) tiles.cell(x, y).tile->assign(Tile::indexOf(x, y), 0);
  SeedPlane seedPlane(search(4));
  for (int y = 0; y < 20; ++y)
  {
    const auto plane = seedPlane.find(tiles.cell(10, y));
    ASSERT_TRUE(plane);
    EXPECT_NEAR(plane->slopeY, 400, 1e-2);
  }
}

/** On cells that look alike from everywhere: which are drawn follows from both keys. */
TEST(SeedPlane, DrawsOtherCellsForOtherSeeds)
{
  TileMap tiles;
  putSquare(tiles, 0, 0, 64, [](int x, int y) { return x % 2 * 700 + y % 2 * 1300; });
  PlaneSearch one = search(4);
  one.hypotheses = 1;
  SeedPlane seedPlane(one);
  int byX = 0, byY = 0;
  const auto slopeAt = [&](int x, int y)
  {
    const auto plane = seedPlane.find(tiles.cell(x, y));
    return plane ? plane->slopeX : 1e9;
  };
  for (int i = 10; i < 50; i += 2)
  {
    byX += slopeAt(i, 20) != slopeAt(i + 2, 20) ? 1 : 0;
    byY += slopeAt(20, i) != slopeAt(20, i + 2) ? 1 : 0;
  }
  EXPECT_GT(byX, 10);
  EXPECT_GT(byY, 10);
}

/** What is random follows from the seed's key, not from what was asked for before. */
TEST(SeedPlane, IsTheSameWheneverItIsAskedFor)
{
  TileMap tiles;
  putSquare(tiles, 0, 0, 40, [](int x, int y) { return 971 * x * y % 3001; });
  SeedPlane first(search(4)), second(search(4));
  int byX = 0, byY = 0;
  for (int key = 5; key < 35; ++key)
  {
    for (int other = 0; other < key % 3; ++other) second.find(tiles.cell(other, other));
    const auto a = first.find(tiles.cell(key, key)), b = second.find(tiles.cell(key, key));
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_EQ(a->slopeX, b->slopeX);
    EXPECT_EQ(a->slopeY, b->slopeY);
    byX += a->slopeX != first.find(tiles.cell(key - 1, key))->slopeX ? 1 : 0;
    byY += a->slopeX != first.find(tiles.cell(key, key - 1))->slopeX ? 1 : 0;
  }
  EXPECT_GT(byX, 10);
  EXPECT_GT(byY, 10);
}

TEST(SeedPlane, OneHypothesisAndBlocksOfAnySizeDo)
{
  TileMap tiles;
  putSquare(tiles, 0, 0, 20, [](int x, int y) { return 100 * (x + y); });
  for (const std::int32_t hypotheses : {1, 2, 3, 64})
    for (const std::int32_t block : {1, 7, 80, 1000})
    {
      PlaneSearch few = search(4);
      few.hypotheses = hypotheses;
      few.blockCells = block;
      SeedPlane seedPlane(few);
      int found = 0;
      for (int key = 4; key < 16; ++key)
      {
        const auto plane = seedPlane.find(tiles.cell(key, key));
        found += plane ? 1 : 0;
        EXPECT_NEAR(plane ? plane->slopeX : 100, 100, 1e-2);
      }
      EXPECT_GE(found, hypotheses == 1 ? 8 : 11);
    }
}
