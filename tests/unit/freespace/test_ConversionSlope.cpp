// The slope layer (eqs. 1-4): hand-worked least squares.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using freespace::ConversionParams;
using test::expectCells;
using test::HandMap;
using test::kNaN;

constexpr float kNear = 1e-6f;
constexpr int kX = HandMap::kNoFloor;

ConversionParams withWindow(int slopeWindow)
{
  auto params = ConversionParams::paper();
  params.slopeWindow = slopeWindow;
  return params;
}

grid::Layer<float> slopeOf(const std::vector<std::vector<int>>& floors, int window,
                           double resolution = 0.1)
{
  HandMap map(resolution);
  map.floors(floors);
  ConversionParams params = withWindow(window);
  params.minClearance = 10 * resolution;
  return map.convert(params).slope;
}

std::vector<std::vector<float>> everywhere(float value)
{
  return std::vector<std::vector<float>>(5, std::vector<float>(5, value));
}

TEST(ConversionSlope, FlatFloorIsExactlyZero)
{
  const std::vector<int> row(5, 12);
  for (const int window : {1, 2, 7, 100})
    expectCells(slopeOf({row, row, row, row, row}, window), everywhere(0));
}

TEST(ConversionSlope, PlaneInX)
{
  const std::vector<int> row{0, 1, 2, 3, 4};
  // a plane is fitted exactly in every window, the clipped ones at the border too
  for (const int window : {1, 2, 3, 100})
    expectCells(slopeOf({row, row, row, row, row}, window), everywhere(1), kNear);
}

TEST(ConversionSlope, PlaneInYDownNorth)
{
  for (const int window : {1, 2, 3})
    expectCells(slopeOf({{0, 0, 0, 0, 0},
                         {3, 3, 3, 3, 3},
                         {6, 6, 6, 6, 6},
                         {9, 9, 9, 9, 9},
                         {12, 12, 12, 12, 12}},
                        window),
                everywhere(3), kNear);
}

TEST(ConversionSlope, DiagonalPlane)
{
  const std::vector<std::vector<int>> floors{
      {4, 5, 6, 7, 8}, {3, 4, 5, 6, 7}, {2, 3, 4, 5, 6}, {1, 2, 3, 4, 5}, {0, 1, 2, 3, 4}};
  for (const int window : {1, 2})
    expectCells(slopeOf(floors, window), everywhere(1.41421356f), kNear);
}

TEST(ConversionSlope, IsMetresPerMetreAtAnyResolution)
{
  // 4 voxels in x and -3 in y per cell: sqrt(16 + 9) = 5
  const std::vector<std::vector<int>> floors{{0, 4, 8, 12, 16},
                                             {3, 7, 11, 15, 19},
                                             {6, 10, 14, 18, 22},
                                             {9, 13, 17, 21, 25},
                                             {12, 16, 20, 24, 28}};
  for (const double resolution : {0.05, 0.07, 0.3, 1.0})
    expectCells(slopeOf(floors, 2, resolution), everywhere(5), 5 * kNear);
}

TEST(ConversionSlope, MissingCellsJustDoNotAdd)
{
  expectCells(slopeOf({{8, kX, 10, 11, 12},
                       {6, kX, kX, 9, 10},
                       {4, 5, kX, 7, kX},
                       {2, 3, 4, kX, 6},
                       {0, 1, kX, 3, 4}},
                      2),
              {{2.23606798f, kNaN, 2.23606798f, 2.23606798f, 2.23606798f},
               {2.23606798f, kNaN, kNaN, 2.23606798f, 2.23606798f},
               {2.23606798f, 2.23606798f, kNaN, 2.23606798f, kNaN},
               {2.23606798f, 2.23606798f, 2.23606798f, kNaN, 2.23606798f},
               {2.23606798f, 2.23606798f, kNaN, 2.23606798f, 2.23606798f}},
              3 * kNear);
}

TEST(ConversionSlope, LeastSquaresThroughABump)
{
  // One cell 3 voxels up. Centre: Sxz/Sxx = 3/6. East: 1.5/1.5. North and south: 3/4 in x and
  // 1.5/1.5 in y, together 1.25. North-east and south-east: 1.5 in x and y.
  expectCells(slopeOf({{0, 0, 0}, {0, 0, 3}, {0, 0, 0}}, 1),
              {{0, 1.25f, 2.12132034f}, {0, 0.5f, 1}, {0, 1.25f, 2.12132034f}}, 3 * kNear);
}

TEST(ConversionSlope, TheWindowEndsAtItsHalfSide)
{
  const std::vector<int> row{0, 0, 0, 0, 0, 0, 4};
  // x within 2: cell 4 sees 2·4/10, cell 5 (four columns left) 1.5·4/5, cell 6 (three) 1·4/2
  const std::vector<float> slopes{0, 0, 0, 0, 0.8f, 1.2f, 2};
  expectCells(slopeOf({row, row, row}, 2), {slopes, slopes, slopes}, 2 * kNear);
  const std::vector<float> narrow{0, 0, 0, 0, 0, 2, 4};  // 1·4/2, then 0.5·4/0.5
  expectCells(slopeOf({row, row, row}, 1), {narrow, narrow, narrow}, 4 * kNear);
}

TEST(ConversionSlope, TheWindowIsASquare)
{
  // the corner cell is within Chebyshev distance 2 of the centre, and outside of a circle
  const grid::Layer<float> slope = slopeOf(
      {{0, 0, 0, 0, 5}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}, 2);
  EXPECT_NEAR(slope.at(2, 2), 0.282842712f, kNear);  // a = b = 2·5/50
}

TEST(ConversionSlope, TheLowestKeptRunIsTheFloor)
{
  HandMap map(0.1);
  for (int kx = 0; kx < 3; ++kx)
    for (int ky = 0; ky < 2; ++ky)
      map.free(kx, ky, 0, 3)
          .occupied(kx, ky, 3, 4)
          .free(kx, ky, 10 + kx, 30)
          .free(kx, ky, 40 + ky, 60);
  // the run [0, 3) is too low to be kept; the next one rises by 1 per cell
  expectCells(map.convert(withWindow(1)).slope, {{1, 1, 1}, {1, 1, 1}}, kNear);
}

TEST(ConversionSlope, FewerThanThreeCellsHaveNone)
{
  HandMap map(0.1);
  map.floors({{kX, 3}, {0, kX}});
  const freespace::Layers layers = map.convert(ConversionParams::paper());
  expectCells(layers.slope, {{kNaN, kNaN}, {kNaN, kNaN}});
  expectCells(layers.ground, {{-1, 0}, {0, -1}});
  EXPECT_EQ(freespace::statistics(layers).slopeUnknown, 2u);
}

TEST(ConversionSlope, ASingleCellHasNone) { expectCells(slopeOf({{7}}, 2), {{kNaN}}); }

TEST(ConversionSlope, ThreeCellsAreEnough)
{
  // 2 up in x, 1 up in y
  expectCells(slopeOf({{1, kX}, {0, 2}}, 1), {{2.23606798f, kNaN}, {2.23606798f, 2.23606798f}},
              3 * kNear);
}

TEST(ConversionSlope, CellsOnOneLineHaveNone)
{
  for (const int window : {1, 2, 5})
  {
    expectCells(slopeOf({{0, 1, 5, 3, 9}}, window), {{kNaN, kNaN, kNaN, kNaN, kNaN}});
    expectCells(slopeOf({{kX, kX, 4}, {kX, 9, kX}, {0, kX, kX}}, window),
                {{kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}});
  }
  // a line that no axis or diagonal runs along: (0, 0), (2, 1), (4, 2)
  expectCells(slopeOf({{kX, kX, kX, kX, 3}, {kX, kX, 1, kX, kX}, {0, kX, kX, kX, kX}}, 4),
              {{kNaN, kNaN, kNaN, kNaN, kNaN},
               {kNaN, kNaN, kNaN, kNaN, kNaN},
               {kNaN, kNaN, kNaN, kNaN, kNaN}});
}

TEST(ConversionSlope, OnlyTheWindowsCellsMustNotBeOnOneLine)
{
  HandMap map(0.1);
  map.floors({{3, kX, kX, kX, kX}, {0, 1, 2, 3, 4}});
  const freespace::Layers layers = map.convert(withWindow(1));
  // cells 0 and 1 see the cell in the north: 1 in x, 3 in y; the others only a row
  expectCells(layers.slope,
              {{3.16227766f, kNaN, kNaN, kNaN, kNaN}, {3.16227766f, 3.16227766f, kNaN, kNaN, kNaN}},
              4 * kNear);
  EXPECT_EQ(freespace::statistics(layers).slopeUnknown, 3u);
}

TEST(ConversionSlope, FarFromTheOriginNothingIsLost)
{
  HandMap map(0.05);
  for (int ky = 0; ky < 3; ++ky)
    for (int kx = 0; kx < 3; ++kx) map.free(32700 + kx, -32768 + ky, 32600 + kx, 32700);
  expectCells(map.convert(withWindow(1)).slope, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, kNear);
}

}  // namespace
