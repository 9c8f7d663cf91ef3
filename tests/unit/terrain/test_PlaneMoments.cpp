#include <gtest/gtest.h>
#include <mrpt_mapconv/terrain/PlaneFit.h>

#include <cmath>
#include <cstdlib>

namespace
{
using namespace mrpt_mapconv::terrain;

/** 4 × 3 cells of height 10 + 2·x − 3·y. */
PlaneMoments exactPlane(std::int32_t x0 = 0, std::int32_t y0 = 0, std::int32_t z0 = 10)
{
  PlaneMoments moments(x0, y0, z0);
  for (std::int32_t y = 0; y < 3; ++y)
    for (std::int32_t x = 0; x < 4; ++x) moments.add(x0 + x, y0 + y, z0 + 2 * x - 3 * y);
  return moments;
}

void expectSame(const PlaneMoments& a, const PlaneMoments& b, std::int32_t kx, std::int32_t ky)
{
  EXPECT_EQ(a.cells(), b.cells());
  EXPECT_DOUBLE_EQ(a.meanX(), b.meanX());
  EXPECT_DOUBLE_EQ(a.meanY(), b.meanY());
  EXPECT_NEAR(a.fit().slopeX, b.fit().slopeX, 1e-12);
  EXPECT_NEAR(a.fit().slopeY, b.fit().slopeY, 1e-12);
  EXPECT_NEAR(a.fit().at(kx, ky), b.fit().at(kx, ky), 1e-6);
  EXPECT_NEAR(a.rms(), b.rms(), 1e-6);
}
}  // namespace

TEST(PlaneMoments, FitFindsAnExactPlane)
{
  const PlaneMoments moments = exactPlane();
  EXPECT_EQ(moments.cells(), 12);
  EXPECT_TRUE(moments.spans());
  const Plane plane = moments.fit();
  EXPECT_NEAR(plane.slopeX, 2, 1e-12);
  EXPECT_NEAR(plane.slopeY, -3, 1e-12);
  EXPECT_NEAR(plane.at(0, 0), 10, 1e-12);
  EXPECT_NEAR(plane.at(7, -2), 30, 1e-12);
  EXPECT_NEAR(moments.rms(), 0, 1e-9);
}

TEST(PlaneMoments, MeanAndHalfWidthsAreThoseOfTheRectangle)
{
  const PlaneMoments moments = exactPlane(100, -7);
  EXPECT_DOUBLE_EQ(moments.meanX(), 101.5);
  EXPECT_DOUBLE_EQ(moments.meanY(), -6);
  // variances of 4 and of 3 evenly spread keys: (n² − 1)/12 = 5/4 and 2/3; half widths √(3·…)
  EXPECT_NEAR(moments.halfWidthX(), std::sqrt(3.75), 1e-12);
  EXPECT_NEAR(moments.halfWidthY(), std::sqrt(2.0), 1e-12);
}

/** Heights 0, 0, 0 and 4 in a square: by hand, slopes 2 and 2, at the corners −1, 1, 1, 3. */
TEST(PlaneMoments, LeastSquaresByHand)
{
  PlaneMoments moments(0, 0, 0);
  moments.add(0, 0, 0);
  moments.add(1, 0, 0);
  moments.add(0, 1, 0);
  moments.add(1, 1, 4);
  const Plane plane = moments.fit();
  EXPECT_NEAR(plane.slopeX, 2, 1e-12);
  EXPECT_NEAR(plane.slopeY, 2, 1e-12);
  EXPECT_NEAR(plane.at(0, 0), -1, 1e-12);
  EXPECT_NEAR(moments.rms(), 1, 1e-12);
}

TEST(PlaneMoments, RemovedCellsLeaveNoTrace)
{
  PlaneMoments moments = exactPlane();
  moments.add(50, 60, -1000);
  moments.add(-3, 2, 77);
  moments.remove(50, 60, -1000);
  moments.remove(-3, 2, 77);
  expectSame(moments, exactPlane(), 1, 1);
}

TEST(PlaneMoments, OthersCanBeAddedWhateverTheirOrigin)
{
  PlaneMoments all(3, 4, 5), other(-1000, 2000, 30000);
  PlaneMoments wanted(0, 0, 0);
  for (int i = 0; i < 40; ++i)
  {
    const std::int32_t x = i * 7 % 11, y = i * 5 % 13, z = i * i % 17;
    (i % 3 ? all : other).add(x, y, z);
    wanted.add(x, y, z);
  }
  const PlaneMoments before = all;
  all.add(other);
  expectSame(all, wanted, 5, 6);
  all.subtract(other);
  expectSame(all, before, 5, 6);
}

TEST(PlaneMoments, FarFromTheOriginNothingIsLost)
{
  constexpr std::int32_t kFar = (1 << 30) - 10;
  for (const std::int32_t x0 : {-kFar, kFar})
    for (const std::int32_t y0 : {-kFar, kFar})
    {
      const PlaneMoments moments = exactPlane(x0, y0, 2000000000);
      EXPECT_TRUE(moments.spans());
      EXPECT_NEAR(moments.fit().slopeX, 2, 1e-12);
      EXPECT_NEAR(moments.fit().slopeY, -3, 1e-12);
      EXPECT_NEAR(moments.fit().at(x0 + 3, y0 + 2), 2000000000, 1e-6);
      EXPECT_NEAR(moments.rms(), 0, 1e-6);
    }
}

/** A thousand by a thousand cells, with steep heights: sums of squares have to hold. */
TEST(PlaneMoments, LargePlanes)
{
  PlaneMoments moments(0, 0, 0);
  for (std::int32_t y = 0; y < 1000; ++y)
    for (std::int32_t x = 0; x < 1000; ++x) moments.add(x, y, 100000 * x - 900000 * y);
  EXPECT_NEAR(moments.fit().slopeX, 100000, 1e-6);
  EXPECT_NEAR(moments.fit().slopeY, -900000, 1e-6);
  EXPECT_LT(moments.rms(), 1);
}

TEST(PlaneMoments, CellsOnOneLineDoNotSpan)
{
  PlaneMoments two(0, 0, 0), row(5, 5, 0), column(0, 0, 0), diagonal(0, 0, 0), knight(9, 9, 0);
  two.add(0, 0, 0);
  two.add(1, 1, 0);
  for (std::int32_t i = 0; i < 2000; ++i)
  {
    row.add(5 + i, 5, i);
    column.add(0, -i, i * i);
    diagonal.add(i, i, 3);
    knight.add(9 + 2 * i, 9 - i, 0);
  }
  for (const PlaneMoments* moments : {&two, &row, &column, &diagonal, &knight})
    EXPECT_FALSE(moments->spans());
  EXPECT_FALSE(PlaneMoments().spans());
}

TEST(PlaneMoments, OneCellBesideALineSpans)
{
  PlaneMoments row(0, 0, 0), diagonal(0, 0, 0);
  for (std::int32_t i = 0; i < 2000; ++i)
  {
    row.add(i, 0, 0);
    diagonal.add(i, i, 0);
  }
  row.add(1000, 1, 0);
  diagonal.add(1000, 1001, 0);
  EXPECT_TRUE(row.spans());
  EXPECT_TRUE(diagonal.spans());
}
