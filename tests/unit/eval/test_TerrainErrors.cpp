#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/TerrainErrors.h>

#include <cmath>
#include <stdexcept>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;
using eval::ErrorSummary;

TEST(TerrainErrors, SummariesByHand)
{
  const ErrorSummary summary = eval::summaryOf({0.1, -0.3, 0.5, 0.1});
  EXPECT_EQ(summary.cells, 4u);
  EXPECT_DOUBLE_EQ(summary.bias, 0.1);
  EXPECT_DOUBLE_EQ(summary.meanAbsolute, 0.25);
  EXPECT_DOUBLE_EQ(summary.rms, 0.3);
}

TEST(TerrainErrors, OfNothingThereIsNone)
{
  const ErrorSummary summary = eval::summaryOf({});
  EXPECT_EQ(summary.cells, 0u);
  for (const double value : {summary.bias, summary.meanAbsolute, summary.rms})
    EXPECT_TRUE(std::isnan(value));
}

TEST(TerrainErrors, EachPlaneHasItsJudgedCells)
{
  eval::TerrainTruth truth;
  truth.height = row({0, 0, 1, 1, 1, 2});
  truth.plane = {truth.height.frame(), -1};
  truth.plane.cells() = {0, 0, 1, 1, 1, -1};
  truth.planes.resize(3);
  CellMask judged = mask(truth.height);
  judged.at(4, 0) = 0;
  // begins a cell later: the first is not known
  const auto errors = eval::errorsOfPlanes(row({0.25F, 0.5F, 1.5F, 9, 9}, 1), truth, judged);
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_EQ(errors[0].cells, 1u);
  EXPECT_DOUBLE_EQ(errors[0].bias, 0.25);
  EXPECT_EQ(errors[1].cells, 2u);
  EXPECT_DOUBLE_EQ(errors[1].bias, 0);
  EXPECT_DOUBLE_EQ(errors[1].rms, 0.5);
  EXPECT_EQ(errors[2].cells, 0u);
}

TEST(TerrainErrors, OtherResolutionsAreRefused)
{
  eval::TerrainTruth truth;
  truth.height = row({0, 0});
  truth.plane = {truth.height.frame(), -1};
  const Layer<float> coarse(GridFrame{1, 0, 0, 2, 1}, 0);
  EXPECT_THROW(eval::errorsOfPlanes(coarse, truth, mask(truth.height)), std::invalid_argument);
}

namespace
{
/** 4 x 4 cells of a plane with the slopes 1/4 and -1/8 a cell [m]. */
Layer<float> slope()
{
  Layer<float> heights(GridFrame{0.5, 3, -2, 4, 4}, 0);
  for (std::int32_t y = 0; y < 4; ++y)
    for (std::int32_t x = 0; x < 4; ++x)
      heights.at(x, y) = 0.25F * static_cast<float>(x) - 0.125F * static_cast<float>(y);
  return heights;
}
}  // namespace

TEST(TerrainErrors, APlaneHasNoResidualsToItself)
{
  const auto residuals = eval::residualsToPlane(slope(), mask(slope()));
  EXPECT_EQ(residuals.cells, 16u);
  EXPECT_NEAR(residuals.rms, 0, 1e-9);
}

TEST(TerrainErrors, ResidualsAreThoseThatNoPlaneHas)
{
  // two columns up and two down, and rows the other way round: no slope, no shift
  Layer<float> heights = slope();
  for (std::int32_t y = 0; y < 4; ++y)
    for (std::int32_t x = 0; x < 4; ++x)
      heights.at(x, y) += ((x == 0 || x == 3) == (y == 0 || y == 3)) ? 0.0625F : -0.0625F;
  const auto residuals = eval::residualsToPlane(heights, mask(heights));
  EXPECT_NEAR(residuals.bias, 0, 1e-9);
  EXPECT_NEAR(residuals.meanAbsolute, 0.0625, 1e-9);
  EXPECT_NEAR(residuals.rms, 0.0625, 1e-9);
}

TEST(TerrainErrors, ALineHasNoPlane)
{
  Layer<float> heights = slope();
  CellMask cells(heights.frame(), 0);
  for (std::int32_t x = 0; x < 4; ++x) cells.at(x, 1) = 1;
  EXPECT_TRUE(std::isnan(eval::residualsToPlane(heights, cells).rms));
  cells.at(0, 2) = 1;
  EXPECT_NEAR(eval::residualsToPlane(heights, cells).rms, 0, 1e-9);
  heights.at(0, 2) = NAN;
  EXPECT_TRUE(std::isnan(eval::residualsToPlane(heights, cells).rms)) << "it is not known";
}
