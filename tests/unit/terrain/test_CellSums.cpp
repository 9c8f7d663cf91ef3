#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../mrpt_mapconv/src/terrain/Tile.h"

namespace
{
using mrpt_mapconv::terrain::CellSums;

struct Point
{
  std::int32_t z;
  std::uint32_t weight;
};

CellSums sumsOf(const std::vector<Point>& points)
{
  CellSums sums;
  for (const Point& p : points) sums.add(p.z, p.weight);
  return sums;
}
}  // namespace

TEST(CellSums, FusedHeightIsWeighted)
{
  EXPECT_EQ(sumsOf({{100, 1}, {200, 3}}).fusedZ(), 175);
  EXPECT_EQ(sumsOf({{-100, 1}, {-200, 3}}).fusedZ(), -175);
}

TEST(CellSums, FusedHeightIsRoundedToTheNearestHalvesUpward)
{
  EXPECT_EQ(sumsOf({{0, 2}, {1, 1}}).fusedZ(), 0);
  EXPECT_EQ(sumsOf({{0, 1}, {1, 1}}).fusedZ(), 1);
  EXPECT_EQ(sumsOf({{0, 1}, {1, 2}}).fusedZ(), 1);
  EXPECT_EQ(sumsOf({{0, 2}, {-1, 1}}).fusedZ(), 0);
  EXPECT_EQ(sumsOf({{0, 1}, {-1, 1}}).fusedZ(), 0);
  EXPECT_EQ(sumsOf({{0, 1}, {-1, 2}}).fusedZ(), -1);
  EXPECT_EQ(sumsOf({{-3, 1}, {-4, 1}}).fusedZ(), -3);
}

TEST(CellSums, HighestIsThatOfSignedHeights)
{
  EXPECT_EQ(sumsOf({{-7, 5}}).highestZ(), -7);
  EXPECT_EQ(sumsOf({{-7, 5}, {-9, 900}}).highestZ(), -7);
  EXPECT_EQ(sumsOf({{-7, 5}, {3, 1}, {2, 9}}).highestZ(), 3);
  EXPECT_EQ(sumsOf({{-7, 5}, {3, 1}, {2, 9}}).highestWeight(), 1u);
}

TEST(CellSums, OfEquallyHighPointsTheSurestCounts)
{
  EXPECT_EQ(sumsOf({{-7, 5}, {-7, 4000000000u}, {-7, 6}}).highestWeight(), 4000000000u);
  EXPECT_EQ(sumsOf({{-7, 5}, {-7, 4000000000u}, {-7, 6}}).highestZ(), -7);
}

TEST(CellSums, DoNotDependOnTheOrderOfPoints)
{
  std::vector<Point> points{{-30, 7}, {4, 100}, {4, 3}, {1 << 30, 16000000}, {-2147000000, 1}};
  const CellSums first = sumsOf(points);
  const auto isLess = [](const Point& a, const Point& b)
  { return a.z != b.z ? a.z < b.z : a.weight < b.weight; };
  std::sort(points.begin(), points.end(), isLess);
  do
  {
    const CellSums sums = sumsOf(points);
    EXPECT_EQ(sums.weightedHeight, first.weightedHeight);
    EXPECT_EQ(sums.weight, first.weight);
    EXPECT_EQ(sums.highest, first.highest);
    EXPECT_EQ(sums.points, 5u);
  } while (std::next_permutation(points.begin(), points.end(), isLess));
}

/** The largest heights with the largest weights, for as long as a cell takes them. */
TEST(CellSums, FullOnesTakeNoMoreAndStayRight)
{
  constexpr std::int32_t kHigh = 65000 * 32768;
  constexpr std::uint32_t kSure = 16000000;  // a sigma of 1 mm
  for (const std::int32_t z : {kHigh, -kHigh})
  {
    CellSums sums;
    for (int i = 0; i < 1000; ++i) sums.add(z, kSure);
    EXPECT_EQ(sums.fusedZ(), z);
    EXPECT_EQ(sums.highestZ(), z);
    EXPECT_LT(sums.points, 100u);
    EXPECT_EQ(sums.weight, std::uint64_t{sums.points} * kSure);
  }
}

/** Heights about 0 never fill Σ w·z: as many of the surest points as can be counted. */
TEST(CellSums, FusedHeightOfManyPointsAboutZero)
{
  CellSums sums;
  sums.points = 4000000000u;
  sums.weight = std::uint64_t{sums.points} * 16000000u;
  for (int i = 0; i < 10; ++i) sums.add(i % 2, 16000000);
  EXPECT_EQ(sums.fusedZ(), 0);
  sums.weightedHeight = -static_cast<std::int64_t>(sums.weight);
  EXPECT_EQ(sums.fusedZ(), -1);
}
