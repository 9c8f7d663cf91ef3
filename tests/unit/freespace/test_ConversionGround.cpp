// The ground occupancy: slope and step tests.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using freespace::ConversionParams;
using test::expectCells;
using test::HandMap;

constexpr int kX = HandMap::kNoFloor;

/** Five equal rows of cells with the given floors, at 0.1 m. */
freespace::Layers profile(const std::vector<int>& row, const ConversionParams& params)
{
  HandMap map(0.1);
  map.floors({row, row, row, row, row});
  return map.convert(params);
}

void expectGroundRows(const freespace::Layers& layers, const std::vector<float>& row)
{
  expectCells(layers.ground, {row, row, row, row, row});
}

// ---- slope

TEST(ConversionGround, SteepFreeCellsAreOccupied)
{
  auto params = ConversionParams::paper();
  params.slopeWindow = 1;
  params.maxSlope = 2;
  // slopes: 0, 0, 3/2 where the rise begins, then 3
  const freespace::Layers layers = profile({0, 0, 0, 3, 6, 9}, params);
  expectGroundRows(layers, {0, 0, 0, 1, 1, 1});
  const std::vector<float> free(6, 0);
  expectCells(layers.aerial, {free, free, free, free, free});
  EXPECT_EQ(freespace::statistics(layers).steep, 15u);
  EXPECT_EQ(freespace::statistics(layers).free, 30u);
}

TEST(ConversionGround, TheSteepestAllowedSlopeIsAllowed)
{
  auto params = ConversionParams::paper();
  params.slopeWindow = 1;
  params.maxSlope = 3;
  expectGroundRows(profile({0, 3, 6, 9}, params), {0, 0, 0, 0});
  params.maxSlope = 2.999;
  expectGroundRows(profile({0, 3, 6, 9}, params), {1, 1, 1, 1});
  params.maxSlope = 0;
  expectGroundRows(profile({4, 4, 4, 4}, params), {0, 0, 0, 0});
  expectGroundRows(profile({4, 4, 4, 4, 5}, params), {0, 0, 0, 1, 1});
}

TEST(ConversionGround, AStepBelowTheSlopesMinStepIsNotMarked)
{
  // 0.6 m: beside it the window of 5 cells gives 3·6/10 = 1.8 < 2
  expectGroundRows(profile({0, 0, 0, 0, 6, 6, 6, 6}, ConversionParams::paper()),
                   {0, 0, 0, 0, 0, 0, 0, 0});
}

TEST(ConversionGround, AStepAboveTheSlopesMinStepIsMarked)
{
  // 0.7 m: 3·7/10 = 2.1 > 2 beside it, 2·7/10 = 1.4 one cell further
  expectGroundRows(profile({0, 0, 0, 0, 7, 7, 7, 7}, ConversionParams::paper()),
                   {0, 0, 0, 1, 1, 0, 0, 0});
  expectGroundRows(profile({7, 7, 7, 7, 0, 0, 0, 0}, ConversionParams::paper()),
                   {0, 0, 0, 1, 1, 0, 0, 0});
}

TEST(ConversionGround, AStepOfExactlyTheSlopesMinStepIsNotMarked)
{
  auto params = ConversionParams::paper();
  params.maxSlope = 1.5;
  EXPECT_DOUBLE_EQ(params.minStep(0.1), 0.5);
  expectGroundRows(profile({0, 0, 0, 0, 5, 5, 5, 5}, params), {0, 0, 0, 0, 0, 0, 0, 0});
  params.maxSlope = 1.499;
  expectGroundRows(profile({0, 0, 0, 0, 5, 5, 5, 5}, params), {0, 0, 0, 1, 1, 0, 0, 0});
}

TEST(ConversionGround, OccupiedAndUnknownCellsStayAsInTheAir)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 10).occupied(1, 0, 0, 6).occupied(2, 0, 0, 10);
  const freespace::Layers layers = map.convert(ConversionParams::paper());
  expectCells(layers.aerial, {{0, 0.6f, -1}});
  expectCells(layers.ground, {{0, 0.6f, -1}});
}

TEST(ConversionGround, ACellOfUnknownSlopeIsNotSteep)
{
  HandMap map(0.1);
  map.floors({{0, 9, 18}});
  expectCells(map.convert(ConversionParams::paper()).ground, {{0, 0, 0}});
}

// ---- steps

ConversionParams withStep(double maxStep)
{
  auto params = ConversionParams::paper();
  params.maxSlope = 1000;  // the steps alone
  params.maxStep = maxStep;
  return params;
}

TEST(ConversionGround, WithoutMaxStepNoStepIsMarked)
{
  expectGroundRows(profile({0, 0, 9, 9}, withStep(0)), {0, 0, 0, 0});
}

TEST(ConversionGround, ACurbIsMarkedOnBothSides)
{
  // 0.2 m, the floor rising to the east: foot and edge
  const std::vector<int> curb{0, 0, 0, 2, 2, 2};
  expectGroundRows(profile(curb, withStep(0.1)), {0, 0, 1, 1, 0, 0});
  expectGroundRows(profile(curb, withStep(0.19)), {0, 0, 1, 1, 0, 0});
}

TEST(ConversionGround, AStepOfExactlyMaxStepIsNone)
{
  const std::vector<int> two{0, 0, 2, 2}, three{0, 0, 3, 3}, six{6, 6, 0, 0};
  expectGroundRows(profile(two, withStep(0.2)), {0, 0, 0, 0});
  // 0.3/0.1 and 0.6/0.1 are a little less than 3 and 6 in double, 3·0.1 a little more than 0.3
  expectGroundRows(profile(three, withStep(0.3)), {0, 0, 0, 0});
  expectGroundRows(profile(six, withStep(0.6)), {0, 0, 0, 0});
  expectGroundRows(profile(three, withStep(0.29)), {0, 1, 1, 0});
  expectGroundRows(profile(six, withStep(0.59)), {0, 1, 1, 0});
}

TEST(ConversionGround, ADropOffIsMarked)
{
  expectGroundRows(profile({9, 9, 9, -200, -200}, withStep(0.5)), {0, 0, 1, 1, 0});
}

TEST(ConversionGround, AThinPostIsMarkedWithAllAroundIt)
{
  HandMap map(0.1);
  map.floors({{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 3, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}});
  expectCells(
      map.convert(withStep(0.2)).ground,
      {{0, 0, 0, 0, 0}, {0, 1, 1, 1, 0}, {0, 1, 1, 1, 0}, {0, 1, 1, 1, 0}, {0, 0, 0, 0, 0}});
}

TEST(ConversionGround, ASlopeOfAllowedStepsIsNoStep)
{
  expectGroundRows(profile({0, 1, 2, 3, 4}, withStep(0.1)), {0, 0, 0, 0, 0});
  // along the diagonal two cells differ by 2 voxels
  HandMap map(0.1);
  map.floors({{1, 2}, {0, 1}});
  expectCells(map.convert(withStep(0.1)).ground, {{0, 1}, {1, 0}});
}

TEST(ConversionGround, CellsWithoutAFloorMakeNoStep)
{
  HandMap map(0.1);
  map.floors({{0, kX, 9}});
  map.occupied(1, 0, 0, 29);
  expectCells(map.convert(withStep(0.1)).ground, {{0, 1, 0}});
}

TEST(ConversionGround, StepsAcrossABlockBorder)
{
  HandMap map(0.1);
  map.free(31, 31, 0, 20).free(32, 32, 4, 24).free(0, 0, 0, 20).free(-1, -1, 4, 24);
  const grid::Layer<float> ground = map.convert(withStep(0.3)).ground;
  for (const int key : {-1, 0, 31, 32})
    EXPECT_EQ(ground.cells()[ground.frame().indexOfKey(key, key)], 1.0f) << "key " << key;
}

TEST(ConversionGround, SlopeAndStepTogether)
{
  auto params = ConversionParams::paper();
  params.maxStep = 0.4;
  // a step of 0.5 m only by maxStep, one of 0.7 m by both
  const freespace::Layers layers = profile({0, 0, 0, 0, 5, 5, 5, 5, 5, 12, 12, 12, 12}, params);
  expectGroundRows(layers, {0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0});
  EXPECT_EQ(freespace::statistics(layers).steep, 20u);
}

}  // namespace
