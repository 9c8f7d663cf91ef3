#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/CellDistance.h>

#include <cmath>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

TEST(CellDistance, IsThatToTheNearestSquare)
{
  // cells of 0.5 m: [0.5, 1) and [3, 3.5) in x, [0, 0.5) in y
  const eval::CellDistance distance(eval::cellsFrom(row({0, 1, 0, 0, 0, 0, 1}), 0.5f));
  EXPECT_DOUBLE_EQ(distance.to({0.2, 0.1}), 0.3);
  EXPECT_DOUBLE_EQ(distance.to({0.6, 0.4}), 0);
  EXPECT_DOUBLE_EQ(distance.to({1.5, 0.25}), 0.5);
  EXPECT_DOUBLE_EQ(distance.to({2.5, 0.25}), 0.5);
  EXPECT_DOUBLE_EQ(distance.to({3.8, 0.9}), 0.5);  // to the corner at (3.5, 0.5)
}

TEST(CellDistance, ToNothingIsInfinite)
{
  EXPECT_TRUE(std::isinf(eval::CellDistance(eval::CellMask()).to({0, 0})));
}
