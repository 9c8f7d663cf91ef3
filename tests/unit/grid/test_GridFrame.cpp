#include <gtest/gtest.h>
#include <mrpt_mapconv/grid/GridFrame.h>

#include <stdexcept>

using mrpt_mapconv::grid::GridFrame;
using mrpt_mapconv::grid::unite;

TEST(GridFrame, metresAreKeysTimesResolution)
{
  const GridFrame frame{0.5, -4, 2, 6, 3};
  EXPECT_EQ(frame.xMin(), -2.0);
  EXPECT_EQ(frame.xMax(), 1.0);
  EXPECT_EQ(frame.yMin(), 1.0);
  EXPECT_EQ(frame.yMax(), 2.5);
  EXPECT_EQ(frame.size(), 18U);
}

TEST(GridFrame, keysAreHalfOpen)
{
  const GridFrame frame{0.5, -4, 2, 6, 3};
  EXPECT_TRUE(frame.containsKey(-4, 2));
  EXPECT_TRUE(frame.containsKey(1, 4));
  EXPECT_FALSE(frame.containsKey(2, 4));
  EXPECT_FALSE(frame.containsKey(1, 5));
  EXPECT_EQ(frame.indexOfKey(-3, 4), 13U);
}

TEST(GridFrame, uniteHoldsBoth)
{
  const GridFrame a{0.1, -4, 2, 6, 3}, b{0.1, 5, -7, 2, 4};
  EXPECT_EQ(unite(a, b), (GridFrame{0.1, -4, -7, 11, 12}));
  EXPECT_EQ(unite(b, a), unite(a, b));
  EXPECT_EQ(unite(a, a), a);
}

TEST(GridFrame, uniteIgnoresEmptyFrames)
{
  const GridFrame a{0.1, -4, 2, 6, 3}, empty{0.7, 100, 100, 0, 5};
  EXPECT_EQ(unite(a, empty), a);
  EXPECT_EQ(unite(empty, a), a);
  EXPECT_TRUE(unite(empty, empty).empty());
}

TEST(GridFrame, uniteRefusesWhatCannotBe)
{
  EXPECT_THROW(unite({0.1, 0, 0, 1, 1}, {0.2, 0, 0, 1, 1}), std::invalid_argument);
  EXPECT_THROW(unite({0.1, -2000000000, 0, 1, 1}, {0.1, 2000000000, 0, 1, 1}), std::length_error);
}
