#include <mrpt/obs/CObservationRange.h>

#include "ScanShapeFixtures.h"

// 2D scans.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::poses::CPose3D;

TEST(CScanShapeGridMap2D, ScansIn2DAreInsertedAsMrptsOwnGridDoes)
{
  const Room room{-9, 12, -6, 7, 2.5};
  for (const double resolution : {0.05, 0.07, 0.1})
    for (const bool widening : {false, true})
    {
      SCOPED_TRACE(mrpt::format("%g %d", resolution, widening));
      auto map = mapForRooms(resolution);
      map.insertionOptions.wideningBeamsWithDistance = widening;
      map.insertionOptions.maxOccupancyUpdateCertainty = 0.7f;
      ASSERT_TRUE(map.insertObservation(scan2DOf(room, CPose3D()), CPose3D()));
      EXPECT_FALSE(map.isEmpty());

      mrpt::maps::COccupancyGridMap2D own(map.getXMin(), map.getXMax(), map.getYMin(),
                                          map.getYMax(), map.getResolution());
      own.insertionOptions = map.insertionOptions;
      own.insertObservation(scan2DOf(room, CPose3D()), CPose3D());
      for (const auto& robot : {CPose3D(1, 0.5, 0, 0.3, 0, 0), CPose3D(2, 1, 0, 1, 0, 0)})
      {
        ASSERT_TRUE(map.insertObservation(scan2DOf(room, robot), robot));
        own.insertObservation(scan2DOf(room, robot), robot);
      }
      ASSERT_EQ(map.getSizeX(), own.getSizeX()) << "the base class has grown its grid";
      ASSERT_EQ(map.getSizeY(), own.getSizeY());
      EXPECT_EQ(map.getRawMap(), own.getRawMap());
      EXPECT_GT(countCells(map, [](int cell) { return cell > 0; }), 1000u);
      EXPECT_GT(countCells(map, [](int cell) { return cell < 0; }), 100u);
    }
}

TEST(CScanShapeGridMap2D, ScansIn2DLeaveTheGridOnItsKeys)
{
  for (const double resolution : {0.05, 0.07, 0.13, 1.0 / 3})
  {
    SCOPED_TRACE(resolution);
    auto map = mapForRooms(resolution);
    for (int i = 0; i < 40; ++i)
    {
      const Room room{-40, 90, -5.0 - i, 4.0 + i, 2.5};
      const CPose3D robot(1.3 * i, 0.2 * i, 0, 0.1 * i, 0, 0);
      ASSERT_TRUE(map.insertObservation(scan2DOf(room, robot), robot));
      const double cells = static_cast<double>(map.getXMin()) / resolution;
      EXPECT_NEAR(cells, std::round(cells), 1e-3) << i;
    }
  }
}

TEST(CScanShapeGridMap2D, OtherObservationsAnd2DScansOnRequestAreIgnored)
{
  auto map = mapForRooms();
  EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservationRange(), CPose3D()));
  map.scanInsertionOptions.insert2D = false;
  EXPECT_FALSE(map.insertObservation(scan2DOf(Room(), CPose3D()), CPose3D()));
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.getSizeX(), 20u);
  map.scanInsertionOptions.insert2D = true;
  EXPECT_TRUE(map.insertObservation(scan2DOf(Room(), CPose3D()), CPose3D()));
}

/** Its rays end in a room whose 3D scan is there: MRPT's margin around them is all that is added.
 */
TEST(CScanShapeGridMap2D, A2DScanClaimsNoMoreRoomThanItsRaysNeed)
{
  const auto before = mapOf(Room());
  auto map = before;
  ASSERT_TRUE(map.insertionOptions.considerInvalidRangesAsFreeSpace);
  map.setSize(-4.7f, 4.7f, -3.7f, 3.7f, 0.1f);  // 17 cells around the room
  ASSERT_TRUE(map.insertObservation(scan2DOf(Room(), CPose3D()), CPose3D()));
  EXPECT_EQ(map.frame(), (grid::GridFrame{0.1, -47, -37, 94, 74}));

  auto ahead = mapForRooms();  // nothing behind a scanner that looks ahead
  auto scan = scan2DOf(Room{-3, 13, -2, 2, 2.5}, CPose3D());
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) scan.setScanRange(i, 12);
  scan.aperture = 0.2f;
  ASSERT_TRUE(ahead.insertObservation(scan, CPose3D()));
  // by hand: 12 m and 2 x 1.6 m along x, of which a quarter is added on either side; 2.4 m across
  EXPECT_GT(ahead.getXMin(), -1.6 - 3.9);
  EXPECT_LT(ahead.getXMax(), 13.6 + 3.9);
  EXPECT_LT(ahead.getYMax(), 1.2 + 1.6 + 1.5);
  EXPECT_LT(cellAt(ahead, 119, 0) + cellAt(ahead, 120, 0), 0) << "the end of the rays";
}

TEST(CScanShapeGridMap2D, RangesOfA2DScanFromItsMaxRangeOnFreeAndOccupyNothing)
{
  auto map = mapForRooms();
  const auto options = map.insertionOptions;
  auto scan = scan2DOf(Room{-3, 13, -2, 2, 2.5}, CPose3D());
  scan.maxRange = 4.1f;
  scan.aperture = 0.2f;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i)
    scan.setScanRange(i, i % 2 == 0 ? 4.1f : 9.0f);
  ASSERT_TRUE(map.insertObservation(scan, CPose3D()));
  EXPECT_EQ(0u, countCells(map, [](int cell) { return cell < 0; }));
  EXPECT_GT(cellAt(map, 39, 0), 0);
  EXPECT_EQ(0, cellAt(map, 42, 0));
  EXPECT_EQ(options.maxDistanceInsertion, map.insertionOptions.maxDistanceInsertion);
}

/** MRPT lays rays of maxDistanceInsertion / 2, or of half the last valid one. */
TEST(CScanShapeGridMap2D, InvalidRaysOfA2DScanHaveRoom)
{
  for (const bool widening : {false, true})
  {
    auto map = mapForRooms();
    map.insertionOptions.wideningBeamsWithDistance = widening;
    auto scan = scan2DOf(Room{-9, 12, -6, 7, 2.5}, CPose3D());
    for (std::size_t i = 0; i < scan.getScanSize(); ++i) scan.setScanRangeValidity(i, i == 200);
    ASSERT_TRUE(map.insertObservation(scan, CPose3D()));
    mrpt::maps::COccupancyGridMap2D own(map.getXMin(), map.getXMax(), map.getYMin(), map.getYMax(),
                                        map.getResolution());
    own.insertionOptions = map.insertionOptions;
    own.insertObservation(scan, CPose3D());
    ASSERT_EQ(map.getSizeX(), own.getSizeX()) << "the base class has grown its grid";
    ASSERT_EQ(map.getSizeY(), own.getSizeY());
    EXPECT_EQ(map.getRawMap(), own.getRawMap());
    EXPECT_GT(map.getPos(-3, -3.5f), 0.5f);
  }
}

/** Far rays without any near the sensor: MRPT counts on its cell. */
TEST(CScanShapeGridMap2D, A2DScanOfOneWideRayHasRoom)
{
  auto map = mapForRooms();
  map.insertionOptions.wideningBeamsWithDistance = true;
  auto scan = scan2DOf(Room{-9, 9, -9, 9, 2.5}, CPose3D());
  scan.resizeScan(1);
  scan.setScanRange(0, 10);
  scan.setScanRangeValidity(0, true);
  scan.aperture = 3;
  ASSERT_TRUE(map.insertObservation(scan, CPose3D()));
  const grid::GridFrame frame = map.frame();
  // by hand: MRPT lays this ray 1.5 rad to the right, and spreads it by 1.5 rad to either side
  EXPECT_TRUE(frame.containsKey(0, 0) && frame.containsKey(99, 0) && frame.containsKey(-98, -14));
}
