#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/NoPath.h>

#include <stdexcept>
#include <string>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;
using eval::NoPath;
using mrpt::math::TPoint2D;

namespace
{
constexpr double kPoint = 0;  // radius of a robot that fits through one cell [m]

/** Why a robot does not get from the middle of a row's first cell to that of its last. */
NoPath why(const Layer<float>& map, const Layer<float>& truth, double radius = kPoint)
{
  const auto& frame = truth.frame();
  const double y = 0.5 * frame.resolution;
  return eval::whyNoPath(map, truth, {frame.xMin() + y, y}, {frame.xMax() - y, y}, radius);
}

NoPath why(std::vector<float> map, std::vector<float> truth)
{
  return why(row(std::move(map)), row(std::move(truth)));
}
}  // namespace

TEST(NoPath, IsDueToWhatHasToBeMadeFree)
{
  const std::vector<float> free{F, F, F, F, F};
  EXPECT_EQ(why({U, F, F, F, F}, free), NoPath::EndUnknown);
  EXPECT_EQ(why({F, F, F, F, U}, free), NoPath::EndUnknown);
  EXPECT_EQ(why({F, F, F, F, O}, free), NoPath::EndOccupied);
  EXPECT_EQ(why({U, F, F, F, O}, free), NoPath::EndOccupied);
  EXPECT_EQ(why({F, F, U, F, F}, free), NoPath::Unknown);
  EXPECT_EQ(why({F, O, O, F, F}, free), NoPath::FalseObstacle);
  EXPECT_EQ(why({F, O, F, U, F}, free), NoPath::UnknownAndFalseObstacle);
  EXPECT_EQ(why({F, F, O, F, F}, {F, F, O, F, F}), NoPath::Truth);
  EXPECT_EQ(why({F, F, F, F, F}, free), NoPath::Heights);
}

TEST(NoPath, WhatIsUnknownAndOccupiedInTruthIsNotMadeFree)
{
  EXPECT_EQ(why({F, F, U, F, F}, {F, F, O, F, F}), NoPath::Truth);
  EXPECT_EQ(why({F, F, U, F, F}, {F, F, U, F, F}), NoPath::Truth);
}

TEST(NoPath, AWayAroundCountsAsWell)
{
  Layer<float> truth(GridFrame{0.5, 0, 0, 4, 2}, F), map = truth;
  map.at(1, 0) = O;
  map.at(1, 1) = U;
  EXPECT_EQ(why(map, truth), NoPath::Unknown) << "either would do; unknown is tried first";
  map.at(1, 1) = O;
  EXPECT_EQ(why(map, truth), NoPath::FalseObstacle);
  truth.at(1, 0) = O;
  EXPECT_EQ(why(map, truth), NoPath::FalseObstacle) << "around what is real";
}

TEST(NoPath, ARobotIsKeptFromAnEndByCellsNearIt)
{
  const Layer<float> truth(GridFrame{0.5, 0, -1, 7, 3}, F);
  const TPoint2D start{0.75, 0.25}, goal{2.75, 0.25};
  const double cell = 0.5;
  Layer<float> map = truth;
  EXPECT_TRUE(eval::canStand(map, start, cell));
  map.at(0, 0) = U;  // touches the start's cell at a corner
  EXPECT_FALSE(eval::canStand(map, start, cell));
  EXPECT_TRUE(eval::canStand(map, start, kPoint));
  EXPECT_EQ(eval::whyNoPath(map, truth, start, goal, cell), NoPath::EndUnknown);
  map.at(0, 0) = O;
  EXPECT_EQ(eval::whyNoPath(map, truth, start, goal, cell), NoPath::EndOccupied);
}

TEST(NoPath, WhatLiesBeyondTheMapIsUnknown)
{
  EXPECT_EQ(why(row({F, F, F, F}), row({F, F, F, F, F})), NoPath::EndUnknown);
  EXPECT_THROW(why(row({F}), Layer<float>(GridFrame{1.0, 0, 0, 1, 1}, F)), std::invalid_argument);
}

TEST(NoPath, EachReasonHasAName)
{
  EXPECT_EQ(eval::namesOf(NoPath{}).size(), static_cast<std::size_t>(NoPath::Heights) + 1);
}
