#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/eval/CellMask.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

TEST(CellMask, CellsOfNamedBodies)
{
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(
      std::string("[world]\nbounds = 0 0 -1 4 1 3\n"
                  "[box.floor]\nmin = 0 0 -1\nmax = 4 1 0\n"
                  "[box.lowWall_1]\nmin = 1 0 0\nmax = 2 1 0.4\n"));
  const auto world = sim::World::fromIni(ini, {});
  const auto cells = eval::cellsOf(world, {"lowWall"}, {0.5, 0, 0, 8, 1});
  EXPECT_EQ(cells.cells(), (std::vector<std::uint8_t>{0, 0, 1, 1, 0, 0, 0, 0}));
}

TEST(CellMask, CellsOfBothMasks)
{
  const auto a = row({0, 1, 1, 1}), b = row({1, 0, 1}, 1);  // the last cells are the same one
  const auto cells = eval::both(eval::cellsFrom(a, 0.5f), eval::cellsFrom(b, 0.5f));
  EXPECT_EQ(cells.frame(), a.frame());
  EXPECT_EQ(cells.cells(), (std::vector<std::uint8_t>{0, 1, 0, 1}));
  EXPECT_THROW(eval::both(mask(a), CellMask(GridFrame{1.0, 0, 0, 4, 1}, 1)), std::invalid_argument);
}

TEST(CellMask, CellsOfOneMaskWithoutThoseOfAnother)
{
  const auto a = row({0, 1, 1, 1}), b = row({1, 0, 1}, 1);  // the last cells are the same one
  const auto cells = eval::without(eval::cellsFrom(a, 0.5f), eval::cellsFrom(b, 0.5f));
  EXPECT_EQ(cells.frame(), a.frame());
  EXPECT_EQ(cells.cells(), (std::vector<std::uint8_t>{0, 0, 1, 0}));
  EXPECT_THROW(eval::without(mask(a), CellMask(GridFrame{1.0, 0, 0, 4, 1}, 1)),
               std::invalid_argument);
}

TEST(CellMask, CellsFromAValueOn)
{
  const auto cells = eval::cellsFrom(row({0.4f, 0.5f, 2, std::nanf("")}), 0.5f);
  EXPECT_EQ(cells.cells(), (std::vector<std::uint8_t>{0, 1, 1, 0}));
}

TEST(CellMask, FreeCells)
{
  const auto cells = eval::freeCells(row({F, O, U, 0.2f, F}));
  EXPECT_EQ(cells.cells(), (std::vector<std::uint8_t>{1, 0, 0, 0, 1}));
  EXPECT_EQ(eval::count(cells), 2u);
}

TEST(CellMask, CellsFarInside)
{
  CellMask all(GridFrame{0.5, 3, -2, 6, 5}, 1);
  EXPECT_EQ(eval::count(eval::inside(all, 0)), 30u);
  EXPECT_EQ(eval::count(eval::inside(all, 1)), 12u) << "beyond the frame there are none";
  EXPECT_EQ(eval::inside(all, 2).cells()[14], 1);  // row 2, column 2
  EXPECT_EQ(eval::inside(all, 2).cells()[15], 1);
  EXPECT_EQ(eval::count(eval::inside(all, 2)), 2u);
  EXPECT_EQ(eval::count(eval::inside(all, 3)), 0u);

  all.at(0, 0) = 0;  // diagonal neighbours count as well
  EXPECT_EQ(eval::inside(all, 1).at(1, 1), 0);
  EXPECT_EQ(eval::count(eval::inside(all, 1)), 11u);
  EXPECT_EQ(eval::inside(all, 2).at(2, 2), 0);
  EXPECT_EQ(eval::inside(all, 2).at(3, 2), 1);
}

TEST(CellMask, CellsAroundThoseOfAMask)
{
  CellMask corner(GridFrame{0.5, 3, -2, 4, 3}, 0);
  corner.at(0, 0) = 1;
  EXPECT_EQ(eval::around(corner, 0).cells(), corner.cells());
  EXPECT_EQ(eval::around(corner, 1).cells(),
            (std::vector<std::uint8_t>{1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(eval::count(eval::around(corner, 9)), 12u);
}
