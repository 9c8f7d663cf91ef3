#include <gtest/gtest.h>

#include <cmath>

#include "../mrpt_mapconv/src/aerial/MeanSlope.h"

namespace
{
using namespace mrpt_mapconv;
using aerial::MeanSlope;
using aerial::tilt;

grid::Layer<float> layerOf(int width, int height, double (*at)(int x, int y))
{
  grid::GridFrame frame;
  frame.resolution = 0.5;
  frame.width = width;
  frame.height = height;
  grid::Layer<float> layer(frame, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) layer.at(x, y) = static_cast<float>(at(x, y));
  return layer;
}

double plane(int x, int y) { return 7 + 0.25 * x - 0.5 * y; }
}  // namespace

TEST(MeanSlope, OfATiltedPlaneIsItsOwn)
{
  for (const int width : {2, 5, 8})
    for (const int height : {2, 3, 6})
    {
      const auto slope = MeanSlope::of(layerOf(width, height, plane));
      EXPECT_DOUBLE_EQ(slope.x, 0.25) << width << " x " << height;
      EXPECT_DOUBLE_EQ(slope.y, -0.5) << width << " x " << height;
    }
}

TEST(MeanSlope, ASingleRowOrColumnHasNoneAcross)
{
  const auto row = MeanSlope::of(layerOf(4, 1, plane));
  EXPECT_DOUBLE_EQ(row.x, 0.25);
  EXPECT_EQ(row.y, 0);
  const auto column = MeanSlope::of(layerOf(1, 4, plane));
  EXPECT_EQ(column.x, 0);
  EXPECT_DOUBLE_EQ(column.y, -0.5);
  const auto cell = MeanSlope::of(layerOf(1, 1, plane));
  EXPECT_EQ(cell.x, 0);
  EXPECT_EQ(cell.y, 0);
}

TEST(MeanSlope, IsThatOfTheLeastSquares)
{
  // heights 0, 0, 3 at -1, 0, 1: 3 / 2
  EXPECT_DOUBLE_EQ(MeanSlope::of(layerOf(3, 1, [](int x, int) { return x == 2 ? 3.0 : 0; })).x,
                   1.5);
}

TEST(MeanSlope, TiltedBackAPlaneIsLevelAtItsMiddle)
{
  auto layer = layerOf(5, 3, plane);
  tilt(layer, -MeanSlope::of(layer));
  for (const float height : layer.cells()) EXPECT_FLOAT_EQ(height, 7 + 0.5F - 0.5F);
  tilt(layer, {0.25, -0.5});
  EXPECT_TRUE(layer.cells() == layerOf(5, 3, plane).cells());
}
