#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "HandTerrain.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainMap;
using terrain::TerrainParams;
}  // namespace

TEST(TerrainMap, KeysAreThoseOfCellsCentredOnMultiplesOfTheResolution)
{
  const TerrainMap map(0.25);  // whose borders floats can tell
  EXPECT_EQ(map.keyOf(0), 0);
  EXPECT_EQ(map.keyOf(0.12), 0);
  EXPECT_EQ(map.keyOf(0.125), 1);
  EXPECT_EQ(map.keyOf(-0.125), 0);
  EXPECT_EQ(map.keyOf(-0.126), -1);
  EXPECT_EQ(map.keyOf(-0.375), -1);
  EXPECT_EQ(map.keyOf(1e6), 4000000);
  EXPECT_EQ(map.keyOf(-1e6), -4000000);
  for (const double beyond : {1e12, -1e12, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(map.keyOf(beyond), std::numeric_limits<std::int32_t>::min());
}

TEST(TerrainMap, PointsOnBordersGoToTheCellAbove)
{
  TerrainMap map(0.25);
  HandScan hand;
  hand.add(0.125, -0.125, 1);
  map.insert(hand.scan(), {});
  EXPECT_TRUE(map.cell(1, 0));
  map.insertPoint(-0.375, 0.375, 1, 0.01);
  EXPECT_TRUE(map.cell(-1, 2));
  EXPECT_EQ(map.cells(), 2u);
}

TEST(TerrainMap, LaterScansDoNotShiftCells)
{
  TerrainMap map(kCell);
  put(map, 3, 4, 1);
  put(map, -1000, -2000, 2);
  EXPECT_EQ(map.cell(3, 4)->height, 1);
  EXPECT_EQ(map.frame().x0, -1000);
  EXPECT_EQ(map.frame().y0, -2000);
  EXPECT_EQ(map.frame().xEnd(), 4);
  EXPECT_EQ(map.frame().yEnd(), 5);
  EXPECT_NEAR(map.frame().xMin(), -1000.5 * kCell, 1e-9);
}

TEST(TerrainMap, ScansArePutWhereTheirSensorWas)
{
  TerrainMap map(0.25);
  HandScan hand;
  hand.sensorPose = mrpt::poses::CPose3D(10, 20, 1, M_PI / 2, 0, 0);
  hand.add(2, 3, -0.5);
  map.insert(hand.scan(), {});
  ASSERT_TRUE(map.cell(4 * 7, 4 * 22));
  EXPECT_NEAR(map.cell(4 * 7, 4 * 22)->height, 0.5, 1e-4);
}

TEST(TerrainMap, ScansMayHaveTheirCoordinatesInterleaved)
{
  const float points[] = {1, 2, 0.5f, 77, 3, 4, 0.25f, 77};
  terrain::TerrainScan scan;
  scan.x = points;
  scan.y = points + 1;
  scan.z = points + 2;
  scan.stride = 4;
  scan.points = 2;
  TerrainMap map(1);
  EXPECT_EQ(map.insert(scan, {}).inserted, 2u);
  EXPECT_EQ(map.cell(1, 2)->height, 0.5);
  EXPECT_EQ(map.cell(3, 4)->height, 0.25);
}

TEST(TerrainMap, CellsAreKnownAtOncePlanesAfterAnUpdate)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 9, 9, 0.5);
  EXPECT_EQ(map.cells(), 100u);
  EXPECT_EQ(map.cell(3, 3)->points, 1u);
  EXPECT_TRUE(map.planes().empty());
  map.update();
  EXPECT_EQ(map.planes().size(), 1u);
  EXPECT_EQ(planeAt(map, 3, 3), 0);
}

/** z = 0.1 + 0.3 x − 0.4 y [m]. */
TEST(TerrainMap, PlanesHaveTiltExtentAndFirstCell)
{
  TerrainMap map(kCell);
  putAll(map, -3, 2, 8, 9, [](int x, int y) { return 0.1 + 0.3 * kCell * x - 0.4 * kCell * y; });
  map.update();
  ASSERT_EQ(map.planes().size(), 1u);
  const terrain::TerrainPlane& plane = map.planes()[0];
  EXPECT_EQ(plane.cells, 12 * 8);
  EXPECT_NEAR(plane.slopeX, 0.3, 1e-4);
  EXPECT_NEAR(plane.slopeY, -0.4, 1e-4);
  EXPECT_NEAR(plane.slope(), 0.5, 1e-4);
  EXPECT_NEAR(plane.x, 2.5 * kCell, 1e-9);
  EXPECT_NEAR(plane.y, 5.5 * kCell, 1e-9);
  EXPECT_NEAR(plane.z, 0.1 + 0.3 * 2.5 * kCell - 0.4 * 5.5 * kCell, 1e-4);
  EXPECT_NEAR(plane.heightAt(0, 0), 0.1, 1e-4);
  EXPECT_LT(plane.rms, 5e-5);
  EXPECT_NEAR(plane.xMin, -3.5 * kCell, 1e-9);
  EXPECT_NEAR(plane.yMin, 1.5 * kCell, 1e-9);
  EXPECT_NEAR(plane.xMax, 8.5 * kCell, 1e-9);
  EXPECT_NEAR(plane.yMax, 9.5 * kCell, 1e-9);
  EXPECT_EQ(plane.firstX, -3);
  EXPECT_EQ(plane.firstY, 2);
  const auto point = map.at(0, 5 * kCell);
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->height, 0.1 - 0.4 * 5 * kCell, 1e-4);
  const double length = std::sqrt(1.25);
  EXPECT_NEAR(point->normal.x, -0.3 / length, 1e-4);
  EXPECT_NEAR(point->normal.y, 0.4 / length, 1e-4);
  EXPECT_NEAR(point->normal.z, 1 / length, 1e-4);
}

TEST(TerrainMap, PlanesAreInTheOrderOfTheirFirstCellsRowByRow)
{
  TerrainMap map(kCell);
  putAll(map, 20, -40, 30, -30, 2);
  putAll(map, -50, -10, -40, 0, 1);
  putAll(map, 60, -40, 70, -30, 3);
  map.update();
  ASSERT_EQ(map.planes().size(), 3u);
  EXPECT_NEAR(map.planes()[0].z, 2, 1e-4);
  EXPECT_NEAR(map.planes()[1].z, 3, 1e-4);
  EXPECT_NEAR(map.planes()[2].z, 1, 1e-4);
}

TEST(TerrainMap, APlaneHasAtLeastMinPlaneCells)
{
  TerrainParams params;
  params.minPlaneCells = 20;
  for (const int rows : {4, 5})
  {
    TerrainMap map(kCell, params);
    putAll(map, 0, 0, 3, rows - 1, 0);
    map.update();
    EXPECT_EQ(map.planes().size(), rows == 5 ? 1u : 0u) << rows;
  }
}

/** Within the tolerance a cell is of the plane, beyond it has its own height. */
TEST(TerrainMap, CellsFurtherThanTheToleranceAreNotOfThePlane)
{
  TerrainParams params;
  params.planeTolerance = 0.03;
  TerrainMap map(kCell, params);
  putAll(map, 0, 0, 20, 20,
         [](int x, int y) {
           return y != 10 ? 0 : x == 5 ? 0.029 : x == 15 ? 0.031 : 0;
         });
  map.update();
  EXPECT_EQ(planeAt(map, 5, 10), 0);
  EXPECT_EQ(planeAt(map, 15, 10), -1);
  EXPECT_NEAR(map.at(15 * kCell, 10 * kCell)->height, 0.031, 1e-4);
  EXPECT_NEAR(map.at(5 * kCell, 10 * kCell)->height, 0, 1e-3);
}

TEST(TerrainMap, MaximumTakesTheHighestPoint)
{
  TerrainParams params;
  params.heightRule = terrain::HeightRule::Maximum;
  TerrainMap map(kCell, params);
  putAll(map, 0, 0, 9, 9, 0);
  putAll(map, 0, 0, 9, 9, 0.5);
  putAll(map, 0, 0, 9, 9, 0.25);
  map.update();
  EXPECT_EQ(map.cell(3, 3)->height, 0.5);
  EXPECT_NEAR(map.at(0, 0)->height, 0.5, 1e-9);
}

TEST(TerrainMap, CopiesAreIndependent)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 39, 39, 0);
  map.update();
  TerrainMap copy(map), assigned(1);
  assigned = map;
  putAll(map, 40, 0, 60, 39, 0);
  for (int i = 0; i < 50; ++i) putAll(map, 10, 0, 10, 39, 3);
  map.update();
  EXPECT_EQ(map.planes().size(), 2u);
  for (TerrainMap* other : {&copy, &assigned})
  {
    EXPECT_EQ(other->resolution(), kCell);
    EXPECT_EQ(other->cells(), 1600u);
    ASSERT_EQ(other->planes().size(), 1u);
    EXPECT_EQ(planeAt(*other, 10, 5), 0);
    putAll(*other, 40, 0, 60, 39, 0);
    other->update();
    EXPECT_EQ(other->planes()[0].cells, 61 * 40);
  }
  const TerrainMap moved(std::move(copy));
  EXPECT_EQ(moved.cells(), 61u * 40u);
}

TEST(TerrainMap, AClearedMapIsLikeANewOne)
{
  TerrainParams params;
  params.minPlaneCells = 5;
  TerrainMap map(kCell, params);
  putAll(map, 0, 0, 39, 39, 0);
  map.update();
  map.clear();
  EXPECT_EQ(map.cells(), 0u);
  EXPECT_EQ(map.leaves(), 0u);
  EXPECT_TRUE(map.planes().empty());
  EXPECT_TRUE(map.frame().empty());
  EXPECT_FALSE(map.at(0, 0));
  EXPECT_EQ(map.params().minPlaneCells, 5);
  putAll(map, 0, 0, 9, 9, 0);
  map.update();
  EXPECT_EQ(map.planes().size(), 1u);
}

TEST(TerrainMap, PlacesThatAreNotKnownHaveNoAnswer)
{
  TerrainMap map(kCell);
  put(map, 0, 0, 1);
  map.update();
  EXPECT_TRUE(map.at(0, 0));
  EXPECT_FALSE(map.at(1, 0));
  EXPECT_FALSE(map.cell(5, 5));
  EXPECT_FALSE(map.at(1e12, 0));
  EXPECT_FALSE(map.at(-1e300, 1e300));
  EXPECT_FALSE(map.at(std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_FALSE(map.at(0, std::numeric_limits<double>::infinity()));
}
