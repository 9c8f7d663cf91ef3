#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/LabelScore.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

namespace
{
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
}  // namespace

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
