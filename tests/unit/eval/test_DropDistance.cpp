#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/DropDistance.h>
#include <mrpt_mapconv/eval/UpperEdges.h>

#include <cmath>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

namespace
{
constexpr double kDrop = 0.3;  // [m]
}

TEST(DropDistance, IsThatToTheSquareOfTheNearestLowerCell)
{
  // cells of 0.5 m: a deck, from x = 1.5 on a yard, from x = 2.5 on the deck again
  const auto floor = row({1, 1, 1, 0, 0, 1, 1});
  const auto below = eval::lowerEdges(floor, kDrop);
  const eval::DropDistance distance(floor, below, kDrop);
  EXPECT_DOUBLE_EQ(distance.to({0.2, 0.1}), 1.3);
  EXPECT_DOUBLE_EQ(distance.to({1.375, 0.4}), 0.125);
  EXPECT_DOUBLE_EQ(distance.to({3.25, 0.25}), 0.75);
}

TEST(DropDistance, IsToCornersAsWell)
{
  Layer<float> floor(GridFrame{0.5, 0, 0, 2, 2}, 1);
  floor.at(1, 1) = 0;
  const eval::DropDistance distance(floor, eval::lowerEdges(floor, kDrop), kDrop);
  EXPECT_DOUBLE_EQ(distance.to({0.2, 0.1}), 0.5);  // 0.3 and 0.4 to the corner at (0.5, 0.5)
}

TEST(DropDistance, OfAPlaceThatIsNotHigherIsInfinite)
{
  const auto floor = row({1, 0, 0.2f, std::nanf("")});
  const eval::DropDistance distance(floor, mask(floor), kDrop);
  EXPECT_TRUE(std::isinf(distance.to({0.75, 0.25}))) << "at its foot";
  EXPECT_TRUE(std::isinf(distance.to({1.25, 0.25}))) << "a step is no drop";
  EXPECT_TRUE(std::isinf(distance.to({1.75, 0.25}))) << "no floor";
  EXPECT_TRUE(std::isinf(distance.to({-0.1, 0.25}))) << "beyond the layer";
  EXPECT_DOUBLE_EQ(distance.to({0.25, 0.25}), 0.25);
}

TEST(DropDistance, CountsTheGivenCellsOnly)
{
  const auto floor = row({1, 0});
  const eval::DropDistance distance(floor, CellMask(floor.frame(), 0), kDrop);
  EXPECT_TRUE(std::isinf(distance.to({0.25, 0.25})));
}
