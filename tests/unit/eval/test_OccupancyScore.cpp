#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/OccupancyScore.h>

#include <cmath>
#include <stdexcept>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

namespace
{
/** 12 × 12 free cells with a wall around; all of them judged. */
Layer<float> room()
{
  Layer<float> layer(GridFrame{0.5, 0, 0, 14, 14}, O);
  for (std::int32_t y = 1; y < 13; ++y)
    for (std::int32_t x = 1; x < 13; ++x) layer.at(x, y) = F;
  return layer;
}
}  // namespace

TEST(OccupancyScore, CountsByHand)
{
  const auto truth = row({F, F, F, O, O, O, U});
  const auto map = row({F, O, U, O, F, U, F});
  const auto score = eval::scoreOccupancy(map, truth, mask(truth));
  EXPECT_EQ(score.free.right, 1u);   // cell 0
  EXPECT_EQ(score.free.wrong, 1u);   // cell 4
  EXPECT_EQ(score.free.found, 1u);   // cell 0
  EXPECT_EQ(score.free.missed, 2u);  // cells 1, 2
  EXPECT_EQ(score.occupied.right, 1u);
  EXPECT_EQ(score.occupied.wrong, 1u);
  EXPECT_EQ(score.occupied.missed, 2u);
  EXPECT_DOUBLE_EQ(score.free.precision(), 0.5);
  EXPECT_DOUBLE_EQ(score.free.recall(), 1.0 / 3);
}

TEST(OccupancyScore, OnlyJudgedCellsCount)
{
  const auto truth = row({F, F, O});
  CellMask judged = mask(truth);
  judged.cells() = {0, 1, 0};
  const auto score = eval::scoreOccupancy(row({O, F, F}), truth, judged);
  EXPECT_EQ(score.free.right, 1u);
  EXPECT_EQ(score.free.wrong + score.free.missed, 0u);
  EXPECT_TRUE(std::isnan(score.occupied.recall()));
}

TEST(OccupancyScore, FramesMayDiffer)
{
  const auto truth = row({F, F, O}, 10);
  const auto map =
      row({O, F, O}, 9);  // its cells 1, 2 lie on the truth's 0, 1; the last is missing
  const auto score = eval::scoreOccupancy(map, truth, mask(truth));
  EXPECT_EQ(score.free.right, 1u);
  EXPECT_EQ(score.occupied.wrong, 1u);
  EXPECT_EQ(score.occupied.missed, 1u);
}

TEST(OccupancyScore, ResolutionsMustAgree)
{
  auto other = row({F});
  const Layer<float> coarse(GridFrame{1.0, 0, 0, 1, 1}, 0);
  EXPECT_THROW(eval::scoreOccupancy(other, coarse, mask(coarse)), std::invalid_argument);
}

TEST(OccupancyScore, WithinOneCell)
{
  const auto truth = row({F, F, F, O, F, F, F});
  EXPECT_DOUBLE_EQ(eval::shareRightWithinOneCell(row({F, F, F, F, O, F, F}), truth, mask(truth)),
                   1.0);
  EXPECT_DOUBLE_EQ(eval::shareRightWithinOneCell(row({F, F, F, F, F, O, F}), truth, mask(truth)),
                   6.0 / 7);
  EXPECT_DOUBLE_EQ(eval::shareRightWithinOneCell(row({U, U, U, U, U, U, U}), truth, mask(truth)),
                   0.0);
}

TEST(OccupancyScore, WithinOneCellBothWaysByHand)
{
  const auto truth = row({F, F, F, O, F, F, F});
  const auto score = eval::scoreWithinOneCell(row({F, O, F, F, O, O, U}), truth, mask(truth));
  EXPECT_EQ(score.occupied.right, 1u);  // cell 4, beside the wall
  EXPECT_EQ(score.occupied.wrong, 2u);  // cells 1, 5
  EXPECT_EQ(score.occupied.found, 1u);
  EXPECT_EQ(score.occupied.missed, 0u);
  EXPECT_EQ(score.free.right, 3u);  // cell 3 as well, since 2 is free
  EXPECT_EQ(score.free.wrong, 0u);
  EXPECT_EQ(score.free.found, 4u);   // cells 0, 1, 2, 4
  EXPECT_EQ(score.free.missed, 2u);  // cells 5, 6
  EXPECT_DOUBLE_EQ(score.occupied.precision(), 1.0 / 3);
  EXPECT_DOUBLE_EQ(score.free.recall(), 4.0 / 6);
}

TEST(OccupancyScore, WithinOneCellTheMiddleIsJudgedAndKnown)
{
  const auto truth = row({O, F, U, F, O});
  CellMask judged = mask(truth);
  judged.cells() = {0, 1, 1, 0, 0};
  const auto score = eval::scoreWithinOneCell(row({F, O, O, F, F}), truth, judged);
  EXPECT_EQ(score.occupied.right, 1u);  // cell 1, by a cell that is not judged itself
  EXPECT_EQ(score.occupied.wrong, 0u);
  EXPECT_EQ(score.free.found, 1u);  // cell 1, likewise
  EXPECT_EQ(score.free.missed + score.free.wrong + score.free.right, 0u);
}

TEST(OccupancyScore, ACheckerboardIsWrongWithinOneCell)
{
  const auto truth = room();
  auto map = truth;
  for (std::int32_t y = 0; y < 14; ++y)
    for (std::int32_t x = 0; x < 14; ++x) map.at(x, y) = (x + y) % 2 ? O : F;
  const auto score = eval::scoreWithinOneCell(map, truth, mask(truth));
  EXPECT_DOUBLE_EQ(eval::shareRightWithinOneCell(map, truth, mask(truth)), 1);
  // Half of the 52 cells of the wall and of the 44 beside it are right, of the 100 others wrong.
  EXPECT_DOUBLE_EQ(score.occupied.precision(), 48.0 / 98);
  EXPECT_DOUBLE_EQ(eval::shareRight(map, truth, mask(truth)), 0.5);
}

TEST(OccupancyScore, AnAllFreeMapFindsNothingOccupied)
{
  const auto truth = room();
  const Layer<float> map(truth.frame(), F);
  const auto score = eval::scoreWithinOneCell(map, truth, mask(truth));
  EXPECT_EQ(score.occupied.recall(), 0);
  EXPECT_TRUE(std::isnan(score.occupied.precision()));
  EXPECT_EQ(score.free.recall(), 1);
  EXPECT_DOUBLE_EQ(eval::shareRight(map, truth, mask(truth)), 144.0 / 196);
}
