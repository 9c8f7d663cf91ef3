#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/ScanShapeMaps.h>

#include "HandMadeScans.h"

namespace mrpt_mapconv
{
using namespace fixtures;

TEST(ScanShapeMaps, CountsForgetNothing)
{
  eval::CountGrid counts(kFrame);
  counts.add(profileOf({{10}}));
  const auto farther = profileOf({{20}});
  for (int i = 0; i < 100; ++i) counts.add(farther);
  const auto labels = counts.labels();
  EXPECT_TRUE(grid::isOccupied(cellOf(labels, 10))) << "once, and a hundred times free since";
  EXPECT_TRUE(grid::isOccupied(cellOf(labels, 20)));
  EXPECT_TRUE(grid::isFree(cellOf(labels, 5)));
  EXPECT_TRUE(grid::isFree(cellOf(labels, 19)));
  EXPECT_EQ(grid::kUnknown, cellOf(labels, 21));
  EXPECT_EQ(grid::kUnknown, cellOf(labels, -5));
}

TEST(ScanShapeMaps, UpdatedCellsAreLabelledByTheirSign)
{
  scan::UpdateParams update;
  update.pHit = 0.7;    // 14 units
  update.pMiss = 0.39;  // 7 units
  eval::UpdatedGrid map(kFrame, update);
  EXPECT_EQ(grid::kUnknown, cellOf(map.labels(), 10));
  map.add(profileOf({{10}}));
  EXPECT_TRUE(grid::isOccupied(cellOf(map.labels(), 10)));
  const auto farther = profileOf({{20}});
  map.add(farther);
  EXPECT_TRUE(grid::isOccupied(cellOf(map.labels(), 10)));
  map.add(farther);
  EXPECT_EQ(grid::kUnknown, cellOf(map.labels(), 10)) << "p = 0.5 again";
  map.add(farther);
  EXPECT_TRUE(grid::isFree(cellOf(map.labels(), 10)));
}

TEST(ScanShapeMaps, EachGridHasItsOwnIncrements)
{
  scan::UpdateParams slow, fast;
  slow.pMiss = 0.45;
  fast.pMiss = 0.1;
  slow.pHit = fast.pHit = 0.7;
  eval::ProfileGrids maps(kFrame, uncut(), {slow, fast});
  maps.insert(scanFrom(0, {{10}}));
  maps.insert(scanFrom(0, {{20}}));
  EXPECT_TRUE(grid::isOccupied(cellOf(maps.labels(0), 10)));
  EXPECT_TRUE(grid::isFree(cellOf(maps.labels(1), 10)));
}

}  // namespace mrpt_mapconv
