// The aerial occupancy (eqs. 5-8): hand-worked overlaps.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using freespace::ConversionParams;
using test::expectCells;
using test::HandMap;

/** A clearance of 4 voxels of 0.1 m. */
ConversionParams withShare(double minOccupancy)
{
  auto params = ConversionParams::paper();
  params.minClearance = 0.4;
  params.minOccupancy = minOccupancy;
  return params;
}

/** Value of a wall beside one free column with voxels [0, height) free. */
float besideFree(int height, const std::string& wall, double minOccupancy, int wallFrom = 0)
{
  HandMap map(0.1);
  map.free(0, 0, 0, height).column(1, 0, wallFrom, wall);
  const freespace::Layers layers = map.convert(withShare(minOccupancy));
  EXPECT_EQ(layers.aerial.at(0, 0), 0.0f);
  return layers.aerial.at(1, 0);
}

TEST(ConversionAerial, WallsAroundAndBetweenFreeCells)
{
  HandMap map(0.1);
  const std::vector<std::string> plan{"fffff",   // north
                                      "f###f",   //
                                      "f###f",   //
                                      "f###f",   //
                                      "ff.ff"};  // south
  for (int row = 0; row < 5; ++row)
    for (int kx = 0; kx < 5; ++kx)
      map.column(
          kx, 4 - row, 0,
          std::string(10, plan[static_cast<std::size_t>(row)][static_cast<std::size_t>(kx)]));
  // the middle of the block touches no free cell; the gap in the south is unknown
  expectCells(
      map.convert(withShare(0.5)).aerial,
      {{0, 0, 0, 0, 0}, {0, 1, 1, 1, 0}, {0, 1, -1, 1, 0}, {0, 1, 1, 1, 0}, {0, 0, -1, 0, 0}});
}

TEST(ConversionAerial, FullOverlap)
{
  EXPECT_EQ(besideFree(10, "##########", 0.5), 1.0f);
  EXPECT_EQ(besideFree(10, "##########", 1.0), 1.0f);
}

TEST(ConversionAerial, PartialOverlap)
{
  EXPECT_EQ(besideFree(10, "#######", 0.5), 0.7f);
  EXPECT_EQ(besideFree(10, "####", 0.5), -1.0f);
  EXPECT_EQ(besideFree(10, "#########", 1.0), -1.0f);
  EXPECT_EQ(besideFree(7, "#####", 0.5), static_cast<float>(5.0 / 7.0));
}

TEST(ConversionAerial, AllOccupiedRunsOfTheColumnCount)
{
  EXPECT_EQ(besideFree(10, "##.ff##f#.", 0.5), 0.5f);
  EXPECT_EQ(besideFree(10, "#f#f#f#f#f", 0.5), 0.5f);
}

TEST(ConversionAerial, OnlyBetweenFloorAndCeiling)
{
  // 3 voxels from below and 2 from above reach into [0, 10)
  EXPECT_EQ(besideFree(10, "########.....##########", 0.5, -5), 0.5f);
  EXPECT_EQ(besideFree(10, "#####", 0.0, -5), -1.0f);
  EXPECT_EQ(besideFree(10, "#####", 0.0, 10), -1.0f);
  EXPECT_EQ(besideFree(10, "######", 0.0, -5), 0.1f);
  EXPECT_EQ(besideFree(10, "######", 0.0, 9), 0.1f);
}

TEST(ConversionAerial, AWallMuchHigherThanTheFreeSpace)
{
  EXPECT_EQ(besideFree(10, std::string(300, '#'), 1.0, -150), 1.0f);
  EXPECT_EQ(besideFree(200, std::string(150, '#'), 0.5, 25), 0.75f);
}

TEST(ConversionAerial, OverlapWithTheWholeSpanOfSeveralRuns)
{
  HandMap map(0.1);
  map.column(0, 0, 0, "ffff####ffff");  // floor 0, ceiling 12; what lies between counts too
  map.column(1, 0, 0, "....####....");
  expectCells(map.convert(withShare(0.3)).aerial, {{0, static_cast<float>(4.0 / 12.0)}});
  expectCells(map.convert(withShare(0.34)).aerial, {{0, -1}});
}

TEST(ConversionAerial, TheNeighboursOwnFloorAndCeilingCount)
{
  HandMap map(0.1);
  map.free(0, 0, 20, 30);  // the wall's own runs do not matter
  map.column(1, 0, 0, "##########ff##########...##");
  // of [20, 30): voxels 20, 21, 25 and 26
  expectCells(map.convert(withShare(0.4)).aerial, {{0, 0.4f}});
}

TEST(ConversionAerial, TheMaximumOverSeveralNeighbours)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 10).occupied(1, 0, 0, 6).free(2, 0, 4, 8);
  expectCells(map.convert(withShare(0.5)).aerial, {{0, 0.6f, 0}});  // 6/10 and 2/4

  HandMap other(0.1);
  other.free(0, 0, 0, 10).occupied(1, 0, 4, 8).free(2, 0, 4, 8);
  expectCells(other.convert(withShare(0.5)).aerial, {{0, 1, 0}});  // 4/10 and 4/4
}

TEST(ConversionAerial, EveryOneOfTheEightNeighboursCounts)
{
  for (int ny = -1; ny <= 1; ++ny)
    for (int nx = -1; nx <= 1; ++nx)
    {
      if (nx == 0 && ny == 0) continue;
      SCOPED_TRACE("neighbour (" + std::to_string(nx) + ", " + std::to_string(ny) + ")");
      HandMap map(0.1);
      map.occupied(0, 0, 0, 8).free(nx, ny, 0, 10);
      const freespace::Layers layers = map.convert(withShare(0.5));
      EXPECT_EQ(layers.aerial.at(-layers.frame().x0, -layers.frame().y0), 0.8f);
    }
}

TEST(ConversionAerial, ACellTwoAwayDoesNot)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 10).occupied(2, 0, 0, 10).occupied(0, 2, 0, 10);
  expectCells(map.convert(withShare(0.5)).aerial, {{-1, -1, -1}, {-1, -1, -1}, {0, -1, -1}});
}

TEST(ConversionAerial, NeighboursAcrossABlockBorder)
{
  HandMap map(0.1);
  map.free(31, 31, 0, 10).occupied(32, 32, 0, 10).occupied(31, 32, 0, 7).occupied(32, 31, 0, 5);
  expectCells(map.convert(withShare(0.5)).aerial, {{0.7f, 1}, {0, 0.5f}});
  HandMap mirrored(0.1);
  mirrored.free(0, 0, 0, 10).occupied(-1, -1, 0, 10).occupied(-1, 0, 0, 7).occupied(0, -1, 0, 5);
  expectCells(mirrored.convert(withShare(0.5)).aerial, {{0.7f, 0}, {1, 0.5f}});
}

TEST(ConversionAerial, NeighboursAcrossTheSideOfABlock)
{
  // the only free neighbour lies in the next block, west, east, south or north; the frame goes on
  // far enough that it does not end beside any of them
  HandMap map(0.1);
  map.occupied(0, 0, 0, 1).occupied(63, 63, 0, 1);
  map.free(31, 48, 0, 10).occupied(32, 48, 0, 6);
  map.free(32, 42, 0, 10).occupied(31, 42, 0, 7);
  map.free(48, 31, 0, 10).occupied(48, 32, 0, 8);
  map.free(42, 32, 0, 10).occupied(42, 31, 0, 9);
  const grid::Layer<float> aerial = map.convert(withShare(0.5)).aerial;
  const auto at = [&](int kx, int ky) { return aerial.cells()[aerial.frame().indexOfKey(kx, ky)]; };
  EXPECT_EQ(at(32, 48), 0.6f);
  EXPECT_EQ(at(31, 42), 0.7f);
  EXPECT_EQ(at(48, 32), 0.8f);
  EXPECT_EQ(at(42, 31), 0.9f);
}

TEST(ConversionAerial, AFreeCellBesideOrUnderObstaclesStaysFree)
{
  HandMap map(0.1);
  map.column(0, 0, 0, "##########").column(1, 0, 0, "ffff######").column(2, 0, 0, "ffffffffff");
  expectCells(map.convert(withShare(0.5)).aerial, {{1, 0, 0}});
}

TEST(ConversionAerial, AColumnWhoseRunsAreTooLowCanBeOccupied)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 10).column(1, 0, 0, "##fff##fff");
  expectCells(map.convert(withShare(0.4)).aerial, {{0, 0.4f}});
}

TEST(ConversionAerial, AColumnWithoutOccupiedVoxelsIsUnknown)
{
  EXPECT_EQ(besideFree(10, "fff.fff.ff", 0.0), -1.0f);
  EXPECT_EQ(besideFree(10, "..........f", 0.0), -1.0f);
}

TEST(ConversionAerial, MinOccupancyItselfIsEnough)
{
  EXPECT_EQ(besideFree(10, "#####", 0.5), 0.5f);
  EXPECT_EQ(besideFree(10, "#####", 0.51), -1.0f);
  EXPECT_EQ(besideFree(12, "######", 0.5), 0.5f);
  EXPECT_EQ(besideFree(11, "#####", 0.5), -1.0f);
}

TEST(ConversionAerial, RoundingOfTheProductLosesNoTie)
{
  // 0.28·25, 0.14·50 and 0.07·100 are 7.000000000000001 in double
  EXPECT_EQ(besideFree(25, "#######", 0.28), 0.28f);
  EXPECT_EQ(besideFree(50, "#######", 0.14), 0.14f);
  EXPECT_EQ(besideFree(100, "#######", 0.07), 0.07f);
  // the tolerance is a billionth of the height
  EXPECT_EQ(besideFree(10, "#####", 0.5 + 0.9e-9), 0.5f);
  EXPECT_EQ(besideFree(10, "#####", 0.5 + 1.1e-9), -1.0f);
}

TEST(ConversionAerial, WithoutMinOccupancyAnyOverlapIsEnoughButNoneIsNot)
{
  EXPECT_EQ(besideFree(10, "#", 0.0), 0.1f);
  EXPECT_EQ(besideFree(100, "#", 0.0, 99), 0.01f);
  EXPECT_EQ(besideFree(10, "#", 0.0, 10), -1.0f);
  EXPECT_EQ(besideFree(10, "#", 0.0, -1), -1.0f);
}

}  // namespace
