#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <limits>

using namespace mrpt_mapconv::grid;

TEST(OccupancyCell, rawCellsByHand)
{
  EXPECT_EQ(rawGridCell(0.0f), 127);
  EXPECT_EQ(rawGridCell(-1.0f), 0);
  EXPECT_EQ(rawGridCell(1.0f), -127);
  EXPECT_EQ(rawGridCell(0.5f), -64);  // 63.5 rounds away from zero
  EXPECT_EQ(rawGridCell(0.001f), -1);
  EXPECT_EQ(rawGridCell(7.0f), -127);
  EXPECT_EQ(rawGridCell(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(OccupancyCell, mrptReadsEveryOccupiedCellAsOccupied)
{
  using Grid = mrpt::maps::COccupancyGridMap2D;
  EXPECT_GT(Grid::l2p(rawGridCell(0.0f)), 0.9f);
  EXPECT_NEAR(Grid::l2p(rawGridCell(-1.0f)), 0.5f, 1e-3f);
  for (int i = 1; i <= 1000; ++i)
    EXPECT_LT(Grid::l2p(rawGridCell(static_cast<float>(i) / 1000)), 0.5f) << i;
}
