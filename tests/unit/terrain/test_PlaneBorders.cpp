#include <gtest/gtest.h>

#include <string>

#include "../mrpt_mapconv/src/terrain/PlaneBorders.h"
#include "HandTiles.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::terrain;

/** Two planes that meet at a border, of which one has taken cells of the other. */
struct TwoPlanes
{
  /** \param along 0: the border is at x = `border`, 1: at y */
  TwoPlanes(int along, int border, int taken)
  {
    search.tolerance = 1000;
    search.mostSlope = 2000;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
      {
        const int at = along == 0 ? x : y;
        const CellRef cell = test::putCell(tiles, x, y, heightAt(at, border));
        const int wanted = at < border ? 0 : 1, given = at < border + taken ? 0 : 1;
        moments[wanted].add(x, y, heightAt(at, border));
        truth[y * 64 + x] = wanted;
        cell.tile->assign(cell.index(), given);
      }
    for (int i = 0; i < 2; ++i)
    {
      const std::int32_t id = planes.add(moments[i]);  // with the right parameters
      for (Tile* tile : tiles.sorted()) planes.at(id).tiles.take(*tile);
    }
  }
  /** A level and a slope that rises from it. */
  static std::int32_t heightAt(int at, int border)
  {
    return at < border ? 0 : 100 * (at - border + 1);
  }

  int wrong() const
  {
    int count = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
      {
        const CellRef cell = tiles.cell(x, y);
        count += cell.tile->plane[cell.index()] == truth[y * 64 + x] ? 0 : 1;
      }
    return count;
  }

  PlaneSearch search;
  TileMap tiles;
  PlaneSet planes;
  PlaneMoments moments[2];
  int truth[64 * 64] = {};
};
}  // namespace

/** At once, in each direction, inside of tiles and across their borders. */
TEST(PlaneBorders, CellsGoToTheNearerPlane)
{
  for (const int along : {0, 1})
    for (int border = 28; border < 36; ++border)
      for (int taken = -9; taken <= 9; ++taken)
      {
        SCOPED_TRACE("along " + std::to_string(along) + ", border " + std::to_string(border) +
                     ", taken " + std::to_string(taken));
        TwoPlanes two(along, border, taken);
        EXPECT_EQ(two.wrong(), 64 * std::abs(taken));
        PlaneBorders borders(two.search, two.tiles, two.planes);
        const bool moved = borders.relax(borders.takeUnsettled(1), 1);
        EXPECT_EQ(moved, taken != 0);
        EXPECT_EQ(two.wrong(), 0);
      }
}

/** The level cells next to the slope's foot, whose height both planes have. */
TEST(PlaneBorders, OfEquallyNearPlanesTheLessSteepGetsTheCell)
{
  TwoPlanes two(0, 32, 0);
  for (int y = 0; y < 64; ++y)
  {
    const CellRef cell = two.tiles.cell(31, y);
    cell.tile->assign(cell.index(), 1);
  }
  PlaneBorders borders(two.search, two.tiles, two.planes);
  borders.relax(borders.takeUnsettled(1), 1);
  EXPECT_EQ(two.wrong(), 0);
}
