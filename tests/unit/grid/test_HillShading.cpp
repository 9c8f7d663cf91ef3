#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "../mrpt_mapconv/src/grid/HillShading.h"

using namespace mrpt_mapconv::grid;
using namespace mrpt_mapconv::grid::picture;
using mrpt::img::TColor;

namespace
{
const TColor kGrey{100, 100, 100};

/** Heights [m] over columns and rows, from the lower left corner on, of cells of 0.5 m. */
Layer<float> heights(int width, int height, const std::function<double(int x, int y)>& at)
{
  GridFrame frame;
  frame.resolution = 0.5;
  frame.width = width;
  frame.height = height;
  Layer<float> layer(frame, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) layer.at(x, y) = static_cast<float>(at(x, y));
  return layer;
}

/** A grey picture of the layer, shaded. */
Raster shaded(const Layer<float>& layer, const Zoom& zoom = {})
{
  const auto pixels = [&zoom](int cells)
  { return zoom.enlarge * ((cells + zoom.reduce - 1) / zoom.reduce); };
  Raster raster;
  raster.width = pixels(layer.frame().width);
  raster.height = pixels(layer.frame().height);
  raster.pixels.assign(static_cast<std::size_t>(raster.width * raster.height), kGrey);
  shadeHills(layer, zoom, raster);
  return raster;
}

int grey(const Raster& raster, int column, int rowFromTop)
{
  const TColor& color =
      raster.pixels.at(static_cast<std::size_t>(rowFromTop * raster.width + column));
  EXPECT_TRUE(color.R == color.G && color.G == color.B);
  return color.R;
}

/** The grey in the middle of a plane that rises so to the east and north [m/m]. */
int greyOfPlane(double east, double north)
{
  return grey(shaded(heights(5, 5, [&](int x, int y) { return 0.5 * (east * x + north * y); })), 2,
              2);
}
}  // namespace

TEST(HillShading, WhatFacesTheNorthWestIsBrighterAndWhatTurnsAwayDarker)
{
  EXPECT_EQ(greyOfPlane(0, 0), 100) << "level";
  EXPECT_GT(greyOfPlane(0.5, 0), 110) << "its normal points west";
  EXPECT_GT(greyOfPlane(0, -0.5), 110) << "north";
  EXPECT_GT(greyOfPlane(0.5, -0.5), greyOfPlane(0.5, 0));
  EXPECT_LT(greyOfPlane(-0.5, 0), 80) << "east";
  EXPECT_LT(greyOfPlane(0, 0.5), 80) << "south";
  EXPECT_LT(greyOfPlane(-0.5, 0.5), greyOfPlane(-0.5, 0));
}

// The light's direction is (-1, 1, sqrt 2)/2; 0.35 of it comes from all sides.
TEST(HillShading, IsLambertsLaw)
{
  const double facing = (0.5 + std::sqrt(2)) / 2 / std::hypot(0.5, 1);
  EXPECT_EQ(greyOfPlane(0.5, 0), std::lround(100 * (0.35 + 0.65 * facing * std::sqrt(2))));
  EXPECT_EQ(greyOfPlane(-10, 10), 35) << "in the shadow";
}

TEST(HillShading, ColoursDoNotOverflow)
{
  const auto layer = heights(3, 3, [](int x, int) { return 0.25 * x; });
  Raster raster{3, 3, std::vector<TColor>(9, TColor(250, 10, 0))};
  shadeHills(layer, {}, raster);
  EXPECT_EQ(raster.pixels[4].R, 255);
  EXPECT_EQ(raster.pixels[4].G, 11);
}

TEST(HillShading, CellsWithoutAHeightAndTheirNeighboursStayAsTheyAre)
{
  const auto slope = [](int x, int y)
  { return x == 2 && y == 3 ? std::numeric_limits<double>::quiet_NaN() : -0.5 * x; };
  const Raster raster = shaded(heights(6, 6, slope));
  for (const auto& [column, row] : {std::pair(2, 2), {1, 2}, {3, 2}, {2, 1}, {2, 3}})
    EXPECT_EQ(grey(raster, column, row), 100) << column << ", " << row;
  for (const auto& [column, row] : {std::pair(4, 2), {1, 1}, {3, 3}, {2, 4}})
    EXPECT_LT(grey(raster, column, row), 80) << column << ", " << row;
}

TEST(HillShading, EnlargedCellsAreShadedAsAWhole)
{
  const auto layer = heights(4, 3, [](int x, int y) { return 0.25 * x * x - 0.125 * x * y; });
  const Raster plain = shaded(layer), enlarged = shaded(layer, {3, 1});
  for (int row = 0; row < enlarged.height; ++row)
    for (int column = 0; column < enlarged.width; ++column)
      EXPECT_EQ(grey(enlarged, column, row), grey(plain, column / 3, row / 3));
}

TEST(HillShading, ReducedPicturesShowTheSlopeOfTheMeanHeights)
{
  const auto ridges = [](int x, int) { return 0.25 * x + (x % 2); };  // 0.5 m/m on the whole
  const Raster raster = shaded(heights(9, 7, ridges), {1, 2});
  ASSERT_EQ(raster.width, 5);
  for (int row = 0; row < raster.height; ++row)
    EXPECT_EQ(grey(raster, 1, row), greyOfPlane(0.5, 0));
}
