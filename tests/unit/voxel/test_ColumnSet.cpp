#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

namespace
{
using mrpt_mapconv::grid::GridFrame;
using mrpt_mapconv::voxel::ColumnSet;
using mrpt_mapconv::voxel::kBlockSide;

/** The slow twin: one entry per column. */
using Columns = std::set<std::pair<std::int32_t, std::int32_t>>;

constexpr unsigned kSeed = 7411;

GridFrame frameAt(std::int32_t x0, std::int32_t y0, std::int32_t width, std::int32_t height)
{
  return {0.1, x0, y0, width, height};
}

/** The columns read bit by bit from the masks. */
Columns columnsOf(const ColumnSet& set)
{
  Columns columns;
  for (const auto& [key, mask] : set.blocks())
    for (std::int32_t y = 0; y < kBlockSide; ++y)
      for (std::int32_t x = 0; x < kBlockSide; ++x)
        if (mask[static_cast<std::size_t>(y)] >> x & 1u)
          columns.emplace(key.x * kBlockSide + x, key.y * kBlockSide + y);
  return columns;
}

Columns columnsOf(const GridFrame& frame)
{
  Columns columns;
  for (std::int32_t y = frame.y0; y < frame.yEnd(); ++y)
    for (std::int32_t x = frame.x0; x < frame.xEnd(); ++x) columns.emplace(x, y);
  return columns;
}

ColumnSet setOf(const Columns& columns)
{
  ColumnSet set;
  for (const auto& [x, y] : columns) set.insert(x, y);
  return set;
}

/** Columns around the origin and around a far negative corner, some of them in a row. */
Columns randomColumns(std::mt19937& random, int count)
{
  const auto between = [&random](std::int32_t low, std::int32_t high)
  { return low + static_cast<std::int32_t>(random() % static_cast<unsigned>(high - low + 1)); };
  Columns columns;
  while (count-- > 0)
  {
    const std::int32_t corner = between(0, 3) == 0 ? -32768 : 0;
    const std::int32_t x = corner + between(-90, 90), y = corner + between(-90, 90);
    for (std::int32_t i = between(0, 3) == 0 ? between(0, 40) : 0; i >= 0; --i)
      columns.emplace(x + i, y);
  }
  return columns;
}

Columns dilatedByHand(const Columns& columns, std::int32_t radius)
{
  Columns inX, out;
  for (const auto& [x, y] : columns)
    for (std::int32_t d = -radius; d <= radius; ++d) inX.emplace(x + d, y);
  for (const auto& [x, y] : inX)
    for (std::int32_t d = -radius; d <= radius; ++d) out.emplace(x, y + d);
  return out;
}

TEST(ColumnSet, InsertsAnotherSet)
{
  mrpt_mapconv::voxel::ColumnSet a, b;
  a.insert(1, 2);
  a.insert(40, 2);
  b.insert(2, 2);
  b.insert(-5, -70);
  a.insert(b);
  EXPECT_EQ(a.size(), 4u);
  EXPECT_TRUE(a.contains(1, 2) && a.contains(40, 2) && a.contains(2, 2) && a.contains(-5, -70));
}

TEST(ColumnSet, StartsEmpty)
{
  const ColumnSet set;
  EXPECT_TRUE(set.empty());
  EXPECT_EQ(set.size(), 0u);
  EXPECT_FALSE(set.contains(0, 0));
  EXPECT_TRUE(set.bounds(0.1).empty());
  EXPECT_EQ(set.bounds(0.1).resolution, 0.1);
  EXPECT_TRUE(set.dilated(5).empty());
  EXPECT_TRUE(set.clipped(frameAt(-5, -5, 10, 10)).empty());
}

TEST(ColumnSet, InsertsAndClears)
{
  ColumnSet set;
  set.insert(-1, -33);
  set.insert(-1, -33);
  set.insert(31, 32);
  EXPECT_EQ(set.size(), 2u);
  EXPECT_EQ(set.blocks().size(), 2u);
  EXPECT_TRUE(set.contains(-1, -33));
  EXPECT_TRUE(set.contains(31, 32));
  EXPECT_FALSE(set.contains(31, -33));
  EXPECT_FALSE(set.contains(-33, -1));
  EXPECT_EQ(set.bounds(0.5), (GridFrame{0.5, -1, -33, 33, 66}));
  set.clear();
  EXPECT_TRUE(set.empty());
}

TEST(ColumnSet, HoldsWhatWasInserted)
{
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  for (const int count : {1, 7, 60, 1000})
  {
    const Columns columns = randomColumns(random, count);
    const ColumnSet set = setOf(columns);
    EXPECT_EQ(set.size(), columns.size());
    EXPECT_EQ(columnsOf(set), columns);
    for (std::int32_t y = -70; y <= 70; ++y)
      for (std::int32_t x = -70; x <= 70; ++x)
        ASSERT_EQ(set.contains(x, y), columns.count({x, y}) > 0) << x << ' ' << y;
  }
}

TEST(ColumnSet, OfAFrameHoldsAllItsColumns)
{
  for (const GridFrame& frame :
       {frameAt(0, 0, 1, 1), frameAt(0, 0, 32, 32), frameAt(-1, -1, 2, 2), frameAt(31, -32, 1, 33),
        frameAt(-40, 5, 100, 3), frameAt(-32768, -32768, 65, 31), frameAt(7, 9, 129, 70)})
  {
    const ColumnSet set = ColumnSet::of(frame);
    EXPECT_EQ(columnsOf(set), columnsOf(frame));
    EXPECT_EQ(set.size(), frame.size());
    EXPECT_EQ(set.bounds(frame.resolution), frame);
  }
  EXPECT_TRUE(ColumnSet::of(GridFrame()).empty());
  EXPECT_TRUE(ColumnSet::of(frameAt(3, 3, 0, 5)).empty());
}

TEST(ColumnSet, DilatesBySquares)
{
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  for (std::int32_t radius = 0; radius <= 70; ++radius)
  {
    const Columns columns = randomColumns(random, 6);
    ASSERT_EQ(columnsOf(setOf(columns).dilated(radius)), dilatedByHand(columns, radius))
        << "radius " << radius;
  }
}

TEST(ColumnSet, DilatesOneColumnAtEveryPlaceOfABlock)
{
  for (const std::int32_t radius : {1, 2, 31, 32, 33, 64})
    for (std::int32_t at = -33; at <= 33; ++at)
    {
      ColumnSet set;
      set.insert(at, -at);
      const std::int32_t side = 2 * radius + 1;
      const ColumnSet dilated = set.dilated(radius);
      ASSERT_EQ(dilated.bounds(0.1), frameAt(at - radius, -at - radius, side, side));
      ASSERT_EQ(dilated.size(), static_cast<std::size_t>(side * side));
    }
}

TEST(ColumnSet, ClipsToAFrame)
{
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  const Columns columns = randomColumns(random, 500);
  const ColumnSet set = setOf(columns);
  for (const GridFrame& frame :
       {frameAt(-10, -20, 33, 50), frameAt(0, 0, 32, 32), frameAt(-64, 31, 128, 1),
        frameAt(500, 500, 10, 10), frameAt(-40000, -40000, 80000, 80000), GridFrame()})
  {
    Columns kept;
    for (const auto& [x, y] : columns)
      if (frame.containsKey(x, y)) kept.emplace(x, y);
    const ColumnSet clipped = set.clipped(frame);
    EXPECT_EQ(columnsOf(clipped), kept);
    EXPECT_EQ(clipped.empty(), kept.empty());
  }
}

TEST(ColumnSet, BoundsAreTight)
{
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  for (int round = 0; round < 50; ++round)
  {
    const Columns columns = randomColumns(random, 1 + round);
    std::int32_t yMin = columns.begin()->second, yMax = yMin;
    for (const auto& [x, y] : columns)
    {
      yMin = std::min(yMin, y);
      yMax = std::max(yMax, y);
    }
    const std::int32_t xMin = columns.begin()->first, xMax = columns.rbegin()->first;
    EXPECT_EQ(setOf(columns).bounds(0.1), frameAt(xMin, yMin, xMax - xMin + 1, yMax - yMin + 1));
  }
}
}  // namespace
