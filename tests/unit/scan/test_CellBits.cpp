#include <gtest/gtest.h>
#include <mrpt_mapconv/scan/CellBits.h>

#include <set>
#include <utility>

namespace
{
using mrpt_mapconv::grid::GridFrame;
using mrpt_mapconv::scan::CellBits;

TEST(CellBits, BeginsEmpty)
{
  const CellBits cells;
  EXPECT_TRUE(cells.frame().empty());
  EXPECT_EQ(cells.count(), 0u);
  EXPECT_FALSE(cells.containsKey(0, 0));
}

TEST(CellBits, HoldsTheCellsThatAreSet)
{
  for (const int width : {1, 63, 64, 65, 130})
  {
    CellBits cells;
    cells.reset({0.5, -40, 7, width, 9});
    std::set<std::pair<int, int>> expected;
    for (int i = 0; i < 50; ++i)
    {
      const int ix = i * 37 % width, iy = i * 5 % 9;
      cells.set(ix, iy);
      expected.emplace(ix, iy);
    }
    EXPECT_EQ(cells.count(), expected.size()) << width;
    for (int iy = 0; iy < 9; ++iy)
      for (int ix = 0; ix < width; ++ix)
      {
        const bool isSet = expected.count({ix, iy}) != 0;
        ASSERT_EQ(cells.test(ix, iy), isSet) << width << ": (" << ix << ", " << iy << ")";
        ASSERT_EQ(cells.containsKey(ix - 40, iy + 7), isSet);
      }
  }
}

TEST(CellBits, KeysOutsideTheFrameAreNotContained)
{
  CellBits cells;
  cells.reset({1.0, -3, -2, 2, 2});
  for (const int ix : {0, 1})
    for (const int iy : {0, 1}) cells.set(ix, iy);
  for (int kx = -6; kx < 3; ++kx)
    for (int ky = -6; ky < 3; ++ky)
      EXPECT_EQ(cells.containsKey(kx, ky), (kx == -3 || kx == -2) && (ky == -2 || ky == -1))
          << "(" << kx << ", " << ky << ")";
}

TEST(CellBits, RowsAreWordsOfSixtyFourColumns)
{
  CellBits cells;
  cells.reset({1.0, 0, 0, 65, 3});
  EXPECT_EQ(cells.wordsPerRow(), 2u);
  cells.set(64, 1);
  cells.set(3, 2);
  EXPECT_EQ(cells.row(1)[0], 0u);
  EXPECT_EQ(cells.row(1)[1], 1u);
  EXPECT_EQ(cells.row(2)[0], 8u);
  cells.row(0)[1] = 1;
  EXPECT_TRUE(cells.test(64, 0));
}

TEST(CellBits, ResetForgetsAllCells)
{
  CellBits cells;
  cells.reset({1.0, 0, 0, 100, 10});
  for (int ix = 0; ix < 100; ++ix) cells.set(ix, ix % 10);
  cells.reset({1.0, 5, 5, 30, 20});
  EXPECT_EQ(cells.count(), 0u);
  EXPECT_TRUE(cells.frame() == (GridFrame{1.0, 5, 5, 30, 20}));
  cells.set(29, 19);
  EXPECT_TRUE(cells.containsKey(34, 24));
  EXPECT_EQ(cells.count(), 1u);
}

}  // namespace
