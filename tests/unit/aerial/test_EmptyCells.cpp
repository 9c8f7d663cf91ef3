#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "../mrpt_mapconv/src/aerial/EmptyCells.h"

namespace
{
using namespace mrpt_mapconv;
using grid::Layer;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

Layer<float> emptyLayer(int width, int height)
{
  grid::GridFrame frame;
  frame.resolution = 0.5;
  frame.width = width;
  frame.height = height;
  return {frame, kNone};
}
}  // namespace

TEST(EmptyCells, AGapInASlopeIsASlope)
{
  auto heights = emptyLayer(40, 3);
  for (int y = 0; y < 3; ++y) heights.at(0, y) = 10, heights.at(39, y) = 29.5F;
  aerial::fillEmptyCells(heights, 1);
  for (int x = 0; x < 40; ++x) EXPECT_NEAR(heights.at(x, 1), 10 + 0.5 * x, 0.01) << x;
}

TEST(EmptyCells, MeasuredHeightsStay)
{
  auto heights = emptyLayer(5, 5);
  heights.at(0, 0) = 3;
  heights.at(4, 4) = -7;
  aerial::fillEmptyCells(heights, 1);
  EXPECT_EQ(heights.at(0, 0), 3);
  EXPECT_EQ(heights.at(4, 4), -7);
}

TEST(EmptyCells, OneHeightIsThatOfAll)
{
  auto heights = emptyLayer(17, 300);
  heights.at(3, 200) = 4;
  aerial::fillEmptyCells(heights, 1);
  for (const float z : heights.cells()) EXPECT_EQ(z, 4);
}

TEST(EmptyCells, WithoutAnyHeightThereIsNothingToFillFrom)
{
  auto heights = emptyLayer(3, 3);
  EXPECT_THROW(aerial::fillEmptyCells(heights, 1), std::invalid_argument);
}

TEST(NearestMeasured, OfEquallyNearCellsTheLowestCounts)
{
  auto heights = emptyLayer(3, 3);
  heights.at(0, 1) = 5;
  heights.at(2, 1) = 4;
  heights.at(1, 0) = 6;
  heights.at(1, 2) = 4;
  EXPECT_EQ(aerial::nearestMeasured(heights, 1)[4], 5U);  // (2, 1), before (1, 2)
  heights.at(1, 2) = 3;
  EXPECT_EQ(aerial::nearestMeasured(heights, 1)[4], 7U);
  heights.at(1, 1) = 9;
  EXPECT_EQ(aerial::nearestMeasured(heights, 1)[4], 4U);  // its own
}
