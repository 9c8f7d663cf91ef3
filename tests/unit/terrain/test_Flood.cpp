#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>
#include <vector>

#include "../mrpt_mapconv/src/terrain/Flood.h"

namespace
{
using namespace mrpt_mapconv::terrain;

using Keys = std::set<std::pair<int, int>>;

/** Makes cells known, of height 0. */
void makeKnown(TileMap& tiles, const Keys& keys)
{
  for (const auto& [x, y] : keys)
  {
    Tile& tile = tiles.get(x >> kTileBits, y >> kTileBits);
    tile.known[static_cast<std::size_t>(y & kTileMask)] |= RowBits{1} << (x & kTileMask);
  }
}

RowBits known(const Tile& tile, std::int32_t iy)
{
  return tile.known[static_cast<std::size_t>(iy)];
}

Keys reached(const Flood& flood)
{
  Keys keys;
  for (const Flood::Part& part : flood.parts())
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      forEachBit(part.reached[static_cast<std::size_t>(iy)],
                 [&](std::int32_t ix) {
                   keys.insert({part.tile->keyX(ix), part.tile->keyY(iy)});
                 });
  return keys;
}

Keys connectedTo(const std::pair<int, int>& seed, const Keys& all)
{
  std::vector<std::pair<int, int>> open{seed};
  Keys found{seed};
  while (!open.empty())
  {
    const auto [x, y] = open.back();
    open.pop_back();
    for (const std::pair<int, int>& next :
         {std::pair{x + 1, y}, std::pair{x - 1, y}, std::pair{x, y + 1}, std::pair{x, y - 1}})
      if (all.count(next) && found.insert(next).second) open.push_back(next);
  }
  return found;
}
}  // namespace

TEST(Flood, ReachesWhatABreadthFirstSearchReaches)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const unsigned percent = 45 + seed % 50;
    Keys keys;
    for (int y = -50; y < 50; ++y)
      for (int x = -70; x < 40; ++x)
        if (random() % 100 < percent) keys.insert({x, y});
    TileMap tiles;
    makeKnown(tiles, keys);
    Flood flood(tiles);
    for (int i = 0; i < 5; ++i)
    {
      const auto first = std::next(keys.begin(), static_cast<long>(random() % keys.size()));
      const Keys wanted = connectedTo(*first, keys);
      const auto count = flood.from(tiles.cell(first->first, first->second), known);
      EXPECT_EQ(static_cast<std::size_t>(count), wanted.size());
      EXPECT_TRUE(reached(flood) == wanted);
    }
  }
}

TEST(Flood, FromAClosedCellReachesNothing)
{
  TileMap tiles;
  makeKnown(tiles, {{0, 0}, {1, 0}});
  Flood flood(tiles);
  EXPECT_EQ(flood.from(tiles.cell(2, 0), known), 0);
}

TEST(Flood, MomentsAreThoseOfTheReachedCells)
{
  TileMap tiles;
  const Keys keys{{-2, 0}, {-1, 0}, {0, 0}, {0, 1}, {-1, -1}, {5, 5}};
  makeKnown(tiles, keys);
  PlaneMoments wanted(0, 0, 0);
  for (const auto& [x, y] : keys)
  {
    const CellRef cell = tiles.cell(x, y);
    cell.tile->height[cell.index()] = 7 * x + 3 * y;
    if (x < 5) wanted.add(x, y, 7 * x + 3 * y);
  }
  Flood flood(tiles);
  EXPECT_EQ(flood.from(tiles.cell(0, 1), known), 5);
  const PlaneMoments moments = flood.moments(tiles.cell(0, 1));
  EXPECT_EQ(moments.cells(), 5);
  EXPECT_DOUBLE_EQ(moments.meanX(), wanted.meanX());
  EXPECT_NEAR(moments.fit().slopeX, 7, 1e-9);
  EXPECT_NEAR(moments.fit().slopeY, 3, 1e-9);
}

TEST(FilledRow, IsWhatIsConnectedInARow)
{
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i)
  {
    const auto within = static_cast<RowBits>(random() | (i % 2 ? random() : 0u));
    const RowBits seeds = static_cast<RowBits>(random() & random()) & within;
    RowBits wanted = seeds;
    for (int step = 0; step < kTileSide; ++step) wanted |= (wanted << 1 | wanted >> 1) & within;
    EXPECT_EQ(filledRow(seeds, within), wanted);
  }
}

/** At the tolerance a cell still lies on the plane, beyond it does not. */
TEST(NearPlane, TakesCellsWithinTheTolerance)
{
  TileMap tiles;
  Tile& tile = tiles.get(-1, 2);
  Plane plane;
  plane.originX = -30;
  plane.originY = 70;
  plane.height = 500;
  plane.slopeX = 3;
  plane.slopeY = -2;
  constexpr std::int32_t kOff[] = {0, 10, 11, -10, -11, 9};
  for (std::int32_t ix = 0; ix < 6; ++ix)
    tile.height[Tile::indexOf(ix, 8)] =
        kOff[ix] + static_cast<std::int32_t>(plane.at(tile.keyX(ix), tile.keyY(8)));
  EXPECT_EQ(nearPlane(plane, 10, tile, 8, 0x3Fu), 0b101011u);
  EXPECT_EQ(nearPlane(plane, 10, tile, 8, 0b110u), 0b010u) << "only those that are asked for";
}
