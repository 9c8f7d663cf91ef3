#include <gtest/gtest.h>
#include <mrpt_mapconv/grid/GrownFrame.h>

using namespace mrpt_mapconv::grid;

namespace
{
bool always(const GridFrame&) { return true; }
bool never(const GridFrame&) { return false; }

const GridFrame kFrame{0.5, -4, -4, 8, 8};
const GrowthMargin kHalf{0.5};

void expectFrame(const GridFrame& frame, const GridFrame& right)
{
  EXPECT_EQ(frame.x0, right.x0);
  EXPECT_EQ(frame.y0, right.y0);
  EXPECT_EQ(frame.width, right.width);
  EXPECT_EQ(frame.height, right.height);
  EXPECT_EQ(frame.resolution, right.resolution);
}
}  // namespace

TEST(GrownFrame, StaysWhereNothingMoreIsNeeded)
{
  expectFrame(grownFrame(kFrame, {0.5, 0, 0, 2, 2}, kHalf, always), kFrame);
  expectFrame(grownFrame(kFrame, {0.5, 0, 0, 0, 0}, kHalf, always), kFrame);
}

TEST(GrownFrame, GetsAMarginOnlyWhereItGrows)
{
  // to the east 2 cells are needed, so it is 10 wide: 5 more
  expectFrame(grownFrame(kFrame, {0.5, 0, 0, 6, 1}, kHalf, always), {0.5, -4, -4, 15, 8});
  // to the south and the west
  expectFrame(grownFrame(kFrame, {0.5, -6, -8, 1, 1}, kHalf, always), {0.5, -11, -14, 15, 18});
}

TEST(GrownFrame, BeginsWithMarginsAllAround)
{
  expectFrame(grownFrame({}, {0.5, 0, 0, 8, 4}, kHalf, always), {0.5, -4, -2, 16, 8});
}

TEST(GrownFrame, MarginsHaveLimits)
{
  GrowthMargin margin{0.5, 1.5};  // 3 cells of 0.5 m
  expectFrame(grownFrame(kFrame, {0.5, 0, 0, 6, 1}, margin, always), {0.5, -4, -4, 13, 8});
  margin = {0.01, 1.5, 1};
  expectFrame(grownFrame(kFrame, {0.5, 0, 0, 6, 1}, margin, always), {0.5, -4, -4, 11, 8});
}

TEST(GrownFrame, HasNoMarginWhereThatIsNotAllowed)
{
  expectFrame(grownFrame(kFrame, {0.5, 0, 0, 6, 1}, kHalf, never), {0.5, -4, -4, 10, 8});
}
