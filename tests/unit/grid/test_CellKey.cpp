#include <gtest/gtest.h>
#include <mrpt_mapconv/grid/CellKey.h>

#include <cmath>

namespace
{
using mrpt_mapconv::grid::cellKey;

TEST(CellKey, HandWorked)
{
  EXPECT_EQ(cellKey(0.0, 0.25), 0);
  EXPECT_EQ(cellKey(0.25, 0.25), 1);
  EXPECT_EQ(cellKey(-0.01, 0.25), -1);
  EXPECT_EQ(cellKey(-0.25, 0.25), -1);
  EXPECT_EQ(cellKey(0.3, 0.1), 2) << "3 * 0.1 is a little more than 0.3";
}

TEST(CellKey, BordersBelongToTheCellAbove)
{
  for (const double res : {0.05, 0.07, 0.08, 0.1, 0.3})
    for (int key = -40000; key <= 40000; ++key)
    {
      const double border = key * res;
      ASSERT_EQ(cellKey(border, res), key) << res;
      ASSERT_EQ(cellKey(std::nextafter(border, -1e9), res), key - 1) << res;
    }
}

}  // namespace
