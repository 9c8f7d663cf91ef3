#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/eval/MapScore.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace

{
using namespace mrpt_mapconv;
using eval::CellMask;
using grid::GridFrame;
using grid::Layer;

constexpr float F = 0, O = 1, U = -1;
const float kNaN = std::nanf("");

Layer<float> row(std::vector<float> cells, std::int32_t x0 = 0)
{
  Layer<float> layer(GridFrame{0.5, x0, 0, static_cast<std::int32_t>(cells.size()), 1}, 0);
  layer.cells() = std::move(cells);
  return layer;
}

CellMask mask(const Layer<float>& like) { return {like.frame(), 1}; }

TEST(MapScore, CountsByHand)
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

TEST(MapScore, OnlyJudgedCellsCount)
{
  const auto truth = row({F, F, O});
  CellMask judged = mask(truth);
  judged.cells() = {0, 1, 0};
  const auto score = eval::scoreOccupancy(row({O, F, F}), truth, judged);
  EXPECT_EQ(score.free.right, 1u);
  EXPECT_EQ(score.free.wrong + score.free.missed, 0u);
  EXPECT_TRUE(std::isnan(score.occupied.recall()));
}

TEST(MapScore, FramesMayDiffer)
{
  const auto truth = row({F, F, O}, 10);
  const auto map =
      row({O, F, O}, 9);  // its cells 1, 2 lie on the truth's 0, 1; the last is missing
  const auto score = eval::scoreOccupancy(map, truth, mask(truth));
  EXPECT_EQ(score.free.right, 1u);
  EXPECT_EQ(score.occupied.wrong, 1u);
  EXPECT_EQ(score.occupied.missed, 1u);
}

TEST(MapScore, ResolutionsMustAgree)
{
  auto other = row({F});
  const Layer<float> coarse(GridFrame{1.0, 0, 0, 1, 1}, 0);
  EXPECT_THROW(eval::scoreOccupancy(other, coarse, mask(coarse)), std::invalid_argument);
}

TEST(MapScore, WithinOneCell)
{
  const auto truth = row({F, F, F, O, F, F, F});
  EXPECT_DOUBLE_EQ(eval::shareRightWithinOneCell(row({F, F, F, F, O, F, F}), truth, mask(truth)),
                   1.0);
  EXPECT_DOUBLE_EQ(eval::shareRightWithinOneCell(row({F, F, F, F, F, O, F}), truth, mask(truth)),
                   6.0 / 7);
  EXPECT_DOUBLE_EQ(eval::shareRightWithinOneCell(row({U, U, U, U, U, U, U}), truth, mask(truth)),
                   0.0);
}

/** 12 × 12 free cells with a wall around; all of them judged. */
Layer<float> room()
{
  Layer<float> layer(GridFrame{0.5, 0, 0, 14, 14}, O);
  for (std::int32_t y = 1; y < 13; ++y)
    for (std::int32_t x = 1; x < 13; ++x) layer.at(x, y) = F;
  return layer;
}

TEST(MapScore, WithinOneCellBothWaysByHand)
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

TEST(MapScore, WithinOneCellTheMiddleIsJudgedAndKnown)
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

TEST(MapScore, ACheckerboardIsWrongWithinOneCell)
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

TEST(MapScore, AnAllFreeMapFindsNothingOccupied)
{
  const auto truth = room();
  const Layer<float> map(truth.frame(), F);
  const auto score = eval::scoreWithinOneCell(map, truth, mask(truth));
  EXPECT_EQ(score.occupied.recall(), 0);
  EXPECT_TRUE(std::isnan(score.occupied.precision()));
  EXPECT_EQ(score.free.recall(), 1);
  EXPECT_DOUBLE_EQ(eval::shareRight(map, truth, mask(truth)), 144.0 / 196);
}

TEST(MapScore, RmseByHand)
{
  const auto error =
      eval::rmse(row({1, 2, kNaN, 5}), row({1, 5, 3, kNaN}), mask(row({0, 0, 0, 0})));
  EXPECT_EQ(error.cells, 2u);
  EXPECT_DOUBLE_EQ(error.value, std::sqrt(9.0 / 2));
}

TEST(MapScore, CellsOfNamedBodies)
{
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(
      std::string("[world]\nbounds = 0 0 -1 4 1 3\n"
                  "[box.floor]\nmin = 0 0 -1\nmax = 4 1 0\n"
                  "[box.lowWall_1]\nmin = 1 0 0\nmax = 2 1 0.4\n"));
  const auto world = sim::World::fromIni(ini, {});
  const auto cells = eval::cellsOf(world, {"lowWall"}, {0.5, 0, 0, 8, 1});
  EXPECT_EQ(cells.cells(), (std::vector<std::uint8_t>{0, 0, 1, 1, 0, 0, 0, 0}));
}

/** A layer from lines of text: '.' is free, '#' occupied, '?' unknown; the first line is y = 0. */
Layer<float> drawn(const std::vector<std::string>& lines)
{
  Layer<float> layer(GridFrame{0.5, 0, 0, static_cast<std::int32_t>(lines[0].size()),
                               static_cast<std::int32_t>(lines.size())},
                     U);
  for (std::size_t i = 0; i < layer.cells().size(); ++i)
  {
    const char c = lines[i / lines[0].size()][i % lines[0].size()];
    layer.cells()[i] = c == '.' ? F : c == '#' ? O : U;
  }
  return layer;
}

/** The same of a mask: 'x' is in it. */
std::vector<std::string> textOf(const CellMask& mask)
{
  std::vector<std::string> lines;
  for (std::int32_t y = 0; y < mask.frame().height; ++y)
  {
    lines.emplace_back();
    for (std::int32_t x = 0; x < mask.frame().width; ++x) lines.back() += mask.at(x, y) ? 'x' : '-';
  }
  return lines;
}

TEST(LabelScore, WhatShouldBeLabelledIsWhatTheStartIsConnectedTo)
{
  const auto truth = drawn({"########?",  //
                            "#..##..#?",  // the rooms only touch at corners
                            "#.#.#..#?",  //
                            "#..######",  //
                            "?####????"});
  const std::vector<std::string> right = {"xxxx-----",  //
                                          "xxxx-----",  // the start is (1, 1)
                                          "xxx------",  //
                                          "xxxx-----",  //
                                          "-xxx-----"};
  EXPECT_EQ(textOf(eval::cellsToLabel(truth, 0.75, 0.75)), right);
  EXPECT_EQ(textOf(eval::cellsToLabel(truth, 1.25, 1.75)), right) << "from another place in it";
  EXPECT_EQ(textOf(eval::cellsToLabel(truth, 3.0, 0.75)),
            (std::vector<std::string>{"----xxxx-",  //
                                      "----xxxx-",  //
                                      "----xxxx-",  //
                                      "----xxxx-",  //
                                      "---------"}));
}

TEST(LabelScore, CornersDoNotConnect)
{
  const auto truth = drawn({".#.", "#.#", ".#."});
  EXPECT_EQ(textOf(eval::cellsToLabel(truth, 0.75, 0.75)),
            (std::vector<std::string>{"-x-", "xxx", "-x-"}));
}

TEST(LabelScore, TheStartMustBeFreeInTruth)
{
  const auto truth = drawn({".#?"});
  EXPECT_EQ(textOf(eval::cellsToLabel(truth, 0.1, 0.1)), std::vector<std::string>{"xx-"});
  for (const double x : {0.7, 1.2, 1.6, -0.1, 1e30})
    EXPECT_THROW(eval::cellsToLabel(truth, x, 0.1), std::invalid_argument) << x;
  try
  {
    eval::cellsToLabel(truth, 0.7, 0.1);
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(),
                 "the place (0.700000, 0.100000) is not valid: its cell must be free in truth");
  }
}

TEST(LabelScore, CountsByHand)
{
  const auto truth = row({F, F, O, O, U, F});
  CellMask should = mask(truth);
  should.cells() = {1, 1, 1, 0, 0, 0};
  // one cell before the truth's frame; its last cell is missing
  const auto map = row({O, F, O, 0.6f, F, F}, -1);
  const auto score = eval::scoreLabels(map, truth, should);
  EXPECT_EQ(score.labelled, 6u);  // also where the truth is unknown or ends
  EXPECT_EQ(score.correct, 2u);   // cells 0, 2
  EXPECT_EQ(score.found, 2u);
  EXPECT_EQ(score.should, 3u);
  EXPECT_DOUBLE_EQ(score.precision(), 1.0 / 3);
  EXPECT_DOUBLE_EQ(score.recall(), 2.0 / 3);
  EXPECT_DOUBLE_EQ(score.fScore(), 4.0 / 9);
}

TEST(LabelScore, RightCellsThatNobodyAskedForAreCorrectButNotFound)
{
  const auto truth = row({F, O, F});
  CellMask should = mask(truth);
  should.cells() = {1, 1, 0};
  const auto score = eval::scoreLabels(row({U, O, F}), truth, should);
  EXPECT_DOUBLE_EQ(score.precision(), 1);
  EXPECT_DOUBLE_EQ(score.recall(), 0.5);
  EXPECT_EQ(score.correct, 2u);
  EXPECT_EQ(score.found, 1u);
}

TEST(LabelScore, CellsBeyondTheMapAreMissed)
{
  const auto truth = row({F, F, F, O});
  const auto score = eval::scoreLabels(row({F}, 2), truth, mask(truth));
  EXPECT_DOUBLE_EQ(score.precision(), 1);
  EXPECT_DOUBLE_EQ(score.recall(), 0.25);
}

TEST(LabelScore, OfNothingIsNoNumber)
{
  const auto truth = row({F, O});
  const CellMask none(truth.frame(), 0);
  const auto empty = eval::scoreLabels(row({U, U}), truth, mask(truth));
  EXPECT_TRUE(std::isnan(empty.precision()));
  EXPECT_EQ(empty.recall(), 0);
  EXPECT_TRUE(std::isnan(empty.fScore()));
  EXPECT_TRUE(std::isnan(eval::scoreLabels(row({F, O}), truth, none).recall()));
  EXPECT_TRUE(std::isnan(eval::scoreLabels(row({O, F}), truth, mask(truth)).fScore()));
  EXPECT_EQ(eval::scoreLabels(row({F, O}), truth, mask(truth)).fScore(), 1);
}

TEST(LabelScore, OccupiedCellsThatTheMapHasFree)
{
  const auto truth = row({O, O, F, U, O});
  const auto map = row({F, F, F, F, O});
  CellMask first = mask(truth);
  first.cells() = {1, 0, 1, 1, 1};
  EXPECT_EQ(eval::occupiedLabelledFree(map, truth, mask(truth)), 2u);
  EXPECT_EQ(eval::occupiedLabelledFree(map, truth, first), 1u);
  EXPECT_EQ(eval::occupiedLabelledFree(row({F}, 1), truth, mask(truth)), 1u);
}

TEST(LabelScore, ResolutionsMustAgree)
{
  const auto map = row({F});
  const Layer<float> coarse(GridFrame{1.0, 0, 0, 1, 1}, 0);
  EXPECT_THROW(eval::scoreLabels(map, coarse, mask(map)), std::invalid_argument);
  EXPECT_THROW(eval::scoreLabels(map, map, mask(coarse)), std::invalid_argument);
  EXPECT_THROW(eval::occupiedLabelledFree(map, coarse, mask(coarse)), std::invalid_argument);
}
}  // namespace
