#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/maps/ObservationPoints.h>
#include <mrpt_mapconv/maps/ScanLog.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>

#include <cstring>
#include <functional>

#include "ScanShapeFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::maps::fixtures;
using mrpt::poses::CPose3D;

namespace
{
std::size_t countCells(const CScanShapeGridMap2D& map, const std::function<bool(int)>& is)
{
  return static_cast<std::size_t>(
      std::count_if(map.getRawMap().begin(), map.getRawMap().end(), is));
}
}  // namespace

TEST(CScanShapeGridMap2D, ANewMapIsSmallEmptyAndUnknown)
{
  const CScanShapeGridMap2D map(0.25);
  EXPECT_TRUE(map.isEmpty());
  EXPECT_LE(map.getSizeX(), 20u);
  EXPECT_FLOAT_EQ(map.getResolution(), 0.25f);
  EXPECT_EQ(map.getCell(0, 0), 0.5f);
  EXPECT_EQ(map.lastScan().points, 0u);
  for (const double bad : {0.0, -1.0, 1e-5, 2e3, std::nan("")})
    EXPECT_THROW(CScanShapeGridMap2D{bad}, std::invalid_argument) << bad;
}

TEST(CScanShapeGridMap2D, TheFloorIsFreeTheWallsAreOccupiedAndTheRestIsUnknown)
{
  const Room room;
  auto map = mapForRooms();
  ASSERT_TRUE(map.insertObservation(scanOf(room, CPose3D()), CPose3D()));
  EXPECT_FALSE(map.isEmpty());
  // a cell of n sixteenths of log-odds is free with 1/(1 + exp(-n/16))
  const scan::LogOddsUpdate update;
  const double miss = 1 / (1 + std::exp(-update.miss() / 16.0)),
               hit = 1 / (1 + std::exp(update.hit() / 16.0));
  EXPECT_NEAR(map.getPos(1.05f, 1.05f), miss, 0.001);
  EXPECT_NEAR(map.getPos(-2.05f, -1.05f), miss, 0.001);
  for (int i = -3; i <= 3; ++i)
  {
    const float along = 0.5f * static_cast<float>(i) + 0.05f;
    // points on a wall lie on the border of two cells
    EXPECT_NEAR(std::min(map.getPos(3.05f, along), map.getPos(2.95f, along)), hit, 0.01) << along;
    EXPECT_NEAR(std::min(map.getPos(along, 2.05f), map.getPos(along, 1.95f)), hit, 0.01) << along;
    EXPECT_EQ(map.getPos(3.25f, along), 0.5f) << along;
    EXPECT_EQ(map.getPos(along, -2.25f), 0.5f) << along;
  }
}

TEST(CScanShapeGridMap2D, AScanInsertedIsItsProfile)
{
  const Room room;
  const CPose3D robot(0.33, 0.12, 5, 1, 0, 0);  // on another storey: heights count from its base
  Room upstairs = room;
  auto scan = scanOf(upstairs, CPose3D(0.33, 0.12, 0, 1, 0, 0));
  auto map = mapForRooms(0.07);
  ASSERT_TRUE(map.insertObservation(scan, robot));

  scan::ScanProfile profile;
  const auto points = maps::sensorPoints(scan, robot);
  ASSERT_TRUE(points);
  profile.compute(points->points, {points->sensorPose, 5, 0}, 0.07,
                  map.scanInsertionOptions.profile);
  const grid::GridFrame frame = map.frame();
  ASSERT_EQ(frame.resolution, 0.07);
  std::vector<std::int8_t> cells(frame.size(), 0);
  scan::LogOddsUpdate().apply(profile, frame, cells.data());
  EXPECT_EQ(map.getRawMap(), cells);
  EXPECT_GT(countCells(map, [](int cell) { return cell < 0; }), 100u);
  EXPECT_GT(countCells(map, [](int cell) { return cell > 0; }), 1000u);
  EXPECT_EQ(map.lastScan().points, points->points.size());
  EXPECT_EQ(map.lastScan().occupiedCells, profile.occupied().count());
  EXPECT_GT(map.lastScan().shareWithWall(), 0.9);
}

TEST(CScanShapeGridMap2D, TheModelIsTheOneAskedFor)
{
  const Room room;
  auto scan = scanOf(room, CPose3D());
  for (int z = 0; z <= 4; ++z)  // a post in front of a wall
    scan.pointcloud->insertPoint(1.35f, 0.05f, 0.1f * static_cast<float>(z) - 0.5f);
  auto whole = mapForRooms(), closest = mapForRooms();
  closest.scanInsertionOptions.profile.model = scan::Model::ClosestPoint;
  ASSERT_TRUE(whole.insertObservation(scan, CPose3D()));
  ASSERT_TRUE(closest.insertObservation(scan, CPose3D()));
  EXPECT_LT(whole.getPos(1.45f, 0.05f), 0.5f);
  EXPECT_LT(closest.getPos(1.45f, 0.05f), 0.5f);
  EXPECT_GT(whole.getPos(2.25f, 0.05f), 0.5f);    // between the post and the wall
  EXPECT_EQ(closest.getPos(2.25f, 0.05f), 0.5f);  // in the post's shadow
}

TEST(CScanShapeGridMap2D, CellsLieOnIntegerKeysAtAnyResolution)
{
  for (const double resolution : {0.05, 0.1, 1.0 / 3, 0.1234567, 0.07})
  {
    SCOPED_TRACE(resolution);
    const CPose3D robot(-37.3, 21.9, 0);
    const Room room{-40.1, -34.2, 19.7, 23.3, 2.5};
    auto map = mapForRooms(resolution);
    ASSERT_TRUE(map.insertObservation(scanOf(room, robot), robot));
    const grid::GridFrame frame = map.frame();
    EXPECT_EQ(frame.resolution, resolution);
    EXPECT_FLOAT_EQ(map.getXMin(), static_cast<float>(frame.x0 * resolution));
    EXPECT_FLOAT_EQ(map.getYMax(), static_cast<float>(frame.yEnd() * resolution));
    const auto key = [&](double metres)
    { return static_cast<std::int32_t>(std::floor(metres / resolution)); };
    EXPECT_GT(cellAt(map, key(-36.5), key(22.5)), 0);
    EXPECT_EQ(cellAt(map, key(-36.5), key(23.3 + 2 * resolution)), 0);
    EXPECT_LT(std::min(cellAt(map, key(-36.5), key(23.3)), cellAt(map, key(-36.5), key(23.29))), 0);
  }
}

TEST(CScanShapeGridMap2D, AGridThatGrowsSaysTheSameAsOneThatIsLarge)
{
  const Room room{-25, 25, -14, 14, 2.5};
  auto growing = mapForRooms(), large = mapForRooms();
  large.setSize(-60, 60, -60, 60, 0.1f);
  for (const auto& robot : {CPose3D(0.4, 0.3, 0), CPose3D(14, 9, 0, 1, 0, 0),
                            CPose3D(-20, 11, 0, 2, 0, 0), CPose3D(-16, -12, 0, 3, 0, 0)})
  {
    ASSERT_TRUE(growing.insertObservation(scanOf(room, robot), robot));
    ASSERT_TRUE(large.insertObservation(scanOf(room, robot), robot));
    EXPECT_TRUE(large.frame() == (grid::GridFrame{0.1, -600, -600, 1200, 1200}));
    expectSameCells(growing, large);
  }
  EXPECT_LT(growing.frame().x0, -200);
  EXPECT_LT(growing.getSizeX(), 1000u);
}

/** As if a Voronoi diagram had been built (MRPT's own way to do so crashes). */
class MapWithVoronoi : public CScanShapeGridMap2D
{
 public:
  explicit MapWithVoronoi(const CScanShapeGridMap2D& map) : CScanShapeGridMap2D(map)
  {
    m_basis_map.setSize(0, 1, 0, 1, 0.1);
    m_voronoi_diagram.setSize(0, 1, 0, 1, 0.1);
    m_basis_map.fill(7);
    m_voronoi_diagram.fill(7);
  }
};

TEST(CScanShapeGridMap2D, AGridThatGrowsHasNoVoronoiDiagramOfTheFormerOne)
{
  MapWithVoronoi map(mapOf(Room()));
  ASSERT_EQ(map.getVoroniClearance(3, 3), 7);
  ASSERT_TRUE(map.insertObservation(scanOf(Room{-15, 15, -15, 15, 2.5}, CPose3D()), CPose3D()));
  EXPECT_EQ(map.getVoroniClearance(3, 3), 0);
  EXPECT_EQ(map.getBasisCell(3, 3), 0);
}

TEST(CScanShapeGridMap2D, ADriveSeldomCopiesTheGrid)
{
  auto map = mapForRooms();
  map.scanInsertionOptions.profile.maxRange = 4;
  int changes = 0;
  const Room corridor{-100, 100, -2, 2, 2.5};
  for (int i = 0; i < 100; ++i)
  {
    const CPose3D robot(0.4 * i, 0, 0);
    const grid::GridFrame before = map.frame();
    ASSERT_TRUE(map.insertObservation(scanOf(corridor, robot), robot));
    changes += map.frame() == before ? 0 : 1;
  }
  EXPECT_LE(changes, 15);
  EXPECT_GE(changes, 2);
}

TEST(CScanShapeGridMap2D, AFirstScanFarAwayDoesNotReachBackToTheOrigin)
{
  const Room room{997, 1003, 498, 502, 2.5};
  const CPose3D robot(1000, 500, 0);
  auto map = mapForRooms();
  ASSERT_TRUE(map.insertObservation(scanOf(room, robot), robot));
  EXPECT_GT(map.getXMin(), 980);
  EXPECT_LT(map.getSizeX(), 200u);
}

TEST(CScanShapeGridMap2D, AGridChangedThroughTheBaseClassIsWhatTheNextScanIsInsertedInto)
{
  const Room room, larger{-4, 4, -4, 4, 2.5};
  auto map = mapOf(room), twin = map;
  map.resizeGrid(-50, 50, -50, 50);
  ASSERT_TRUE(map.insertObservation(scanOf(larger, CPose3D()), CPose3D()));
  ASSERT_TRUE(twin.insertObservation(scanOf(larger, CPose3D()), CPose3D()));
  EXPECT_NE(map.getSizeX(), twin.getSizeX());
  expectSameCells(map, twin);

  map.setSize(-10, 10, -10, 10, 0.25f);  // erased, and coarser
  auto coarse = mapForRooms(0.25);
  EXPECT_EQ(map.frame().resolution, 0.25);
  ASSERT_TRUE(map.insertObservation(scanOf(room, CPose3D()), CPose3D()));
  ASSERT_TRUE(coarse.insertObservation(scanOf(room, CPose3D()), CPose3D()));
  expectSameCells(map, coarse);

  auto written = mapForRooms();  // a cell that somebody sets before the first scan stays
  written.setPos(-0.95f, -0.95f, 0.1f);
  const Room aside{10, 14, 10, 14, 2.5};
  const CPose3D robot(12, 12, 0);
  ASSERT_TRUE(written.insertObservation(scanOf(aside, robot), robot));
  EXPECT_NEAR(written.getPos(-0.95f, -0.95f), 0.1f, 0.01f);
  EXPECT_GT(written.getPos(12.55f, 12.55f), 0.5f);
}

TEST(CScanShapeGridMap2D, AGridOfAnOddResolutionResizedBehindItsBackStaysOnItsKeys)
{
  for (const double resolution : {0.07, 1.0 / 3, 0.1234567})
  {
    SCOPED_TRACE(resolution);
    const Room room, larger{-15, 15, -16, 16, 2.5};
    auto map = mapOf(room, resolution), twin = map;
    map.resizeGrid(-13.3f, 11.1f, -9.7f, 12.9f);
    ASSERT_TRUE(map.insertObservation(scanOf(larger, CPose3D()), CPose3D()));
    ASSERT_TRUE(twin.insertObservation(scanOf(larger, CPose3D()), CPose3D()));
    expectSameCells(map, twin);
  }
}

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

TEST(CScanShapeGridMap2D, PointsThatAreNotFiniteAreLeftOut)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  auto clean = mapForRooms(), map = mapForRooms();
  auto scan = scanOf(Room(), CPose3D());
  clean.insertObservation(scan, CPose3D());
  scan.pointcloud->insertPointFast(nan, 1, 0);
  scan.pointcloud->insertPointFast(1, inf, 0);
  scan.pointcloud->insertPointFast(1, 1, -inf);
  scan.pointcloud->insertPointFast(0, 0, 0);  // at the sensor
  scan.pointcloud->insertPointFast(1e-6f, 0, 0);
  const WarningsOf warnings(map);
  ASSERT_TRUE(map.insertObservation(scan, CPose3D()));
  EXPECT_EQ(map.getRawMap(), clean.getRawMap());
  ASSERT_EQ(warnings.texts.size(), 1u);
  EXPECT_TRUE(contains(warnings.texts[0], "3 points with NaN")) << warnings.texts[0];
}

TEST(CScanShapeGridMap2D, WarnsOnceIfFewAzimuthsHaveAWall)
{
  auto map = mapForRooms();
  const WarningsOf warnings(map);
  const Room high{-3, 3, -2, 2, 9};
  map.scanInsertionOptions.profile.structureMinZ = 8.8;
  map.scanInsertionOptions.profile.structureMaxZ = 8.9;
  for (int i = 0; i < 3; ++i)
    ASSERT_TRUE(map.insertObservation(scanOf(high, CPose3D()), CPose3D()));
  EXPECT_LT(map.lastScan().shareWithWall(), 0.1);
  ASSERT_EQ(warnings.texts.size(), 1u);
  EXPECT_TRUE(contains(warnings.texts[0], "structureMinZ = 8.8 m")) << warnings.texts[0];

  auto unfiltered = mapForRooms();
  const WarningsOf none(unfiltered);
  unfiltered.scanInsertionOptions.profile.reflectionFilter = false;
  ASSERT_TRUE(unfiltered.insertObservation(scanOf(high, CPose3D()), CPose3D()));
  EXPECT_TRUE(none.texts.empty());
}

TEST(CScanShapeGridMap2D, SaysAtLevelDebugWhatItFoundInEachScan)
{
  auto map = mapForRooms();
  std::vector<std::string> said;
  map.log().setMinLoggingLevel(mrpt::system::LVL_DEBUG);
  map.log().setVerbosityLevelForCallbacks(mrpt::system::LVL_DEBUG);
  map.log().logRegisterCallback([&](std::string_view text, const mrpt::system::VerbosityLevel,
                                    std::string_view, const mrpt::Clock::time_point)
                                { said.emplace_back(text); });
  map.insertObservation(scanOf(Room(), CPose3D()), CPose3D());  // says more, see below
  said.clear();
  for (int i = 0; i < 2; ++i) map.insertObservation(scanOf(Room(), CPose3D()), CPose3D());
  ASSERT_EQ(said.size(), 2u);
  EXPECT_TRUE(contains(said[0], "'LIDAR'") && contains(said[0], "a wall on 100.0 %")) << said[0];
}

/** At a level that stock programs show. */
TEST(CScanShapeGridMap2D, SaysWhatShareOfTheFirst3DScanHasAWall)
{
  auto map = mapForRooms();
  std::vector<std::string> said;
  map.log().setVerbosityLevelForCallbacks(mrpt::system::LVL_INFO);
  map.log().logRegisterCallback([&](std::string_view text, const mrpt::system::VerbosityLevel,
                                    std::string_view, const mrpt::Clock::time_point)
                                { said.emplace_back(text); });
  map.insertObservation(scan2DOf(Room(), CPose3D()), CPose3D());
  EXPECT_TRUE(said.empty());
  for (int i = 0; i < 3; ++i) map.insertObservation(scanOf(Room(), CPose3D()), CPose3D());
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(contains(said[0], "'LIDAR': a wall on 100.0 % of ")) << said[0];

  // as rbpf-slam copies its particles' maps
  mrpt::io::CMemoryStream memory;
  auto stream = mrpt::serialization::archiveFrom(memory);
  stream << map;
  memory.Seek(0);
  auto copy = mapForRooms();
  copy.log().setVerbosityLevelForCallbacks(mrpt::system::LVL_INFO);
  copy.log().logRegisterCallback([&](std::string_view text, const mrpt::system::VerbosityLevel,
                                     std::string_view, const mrpt::Clock::time_point)
                                 { said.emplace_back(text); });
  stream >> copy;
  copy.insertObservation(scanOf(Room(), CPose3D()), CPose3D());
  EXPECT_EQ(said.size(), 1u);
}

TEST(CScanShapeGridMap2D, ItsLayersAreProbabilitiesAndOccupancies)
{
  auto map = mapOf(Room());
  map.insertObservation(scanOf(Room(), CPose3D()), CPose3D());
  const auto p = map.probability(), o = map.occupancy();
  ASSERT_EQ(p.frame(), map.frame());
  ASSERT_EQ(o.frame(), map.frame());
  std::size_t free = 0, occupied = 0;
  for (std::size_t i = 0; i < p.cells().size(); ++i)
  {
    const int raw{map.getRawMap()[i]};
    const double expected = 1 / (1 + std::exp(raw / 16.0));
    if (raw == 0)
    {
      ASSERT_TRUE(std::isnan(p.cells()[i]) && o.cells()[i] == grid::kUnknown) << i;
      continue;
    }
    ASSERT_NEAR(p.cells()[i], expected, 1e-5) << i;
    ASSERT_EQ(o.cells()[i], raw > 0 ? grid::kFree : p.cells()[i]) << i;
    ++(raw > 0 ? free : occupied);
  }
  EXPECT_GT(free, 1000u);
  EXPECT_GT(occupied, 100u);
}

TEST(CScanShapeGridMap2D, ClearForgetsTheCellsAndKeepsTheOptions)
{
  auto map = mapOf(Room(), 0.07);
  map.clear();
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.getSizeX(), 20u);
  EXPECT_EQ(map.frame().resolution, 0.07);
  EXPECT_EQ(map.scanInsertionOptions.profile.structureMinZ, 2);
  EXPECT_EQ(countCells(map, [](int cell) { return cell != 0; }), 0u);
  map.setSize(-1, 1, -1, 1, 0.5f);
  map.clear();
  EXPECT_EQ(map.frame().resolution, 0.5) << "as the base class does";
}

TEST(CScanShapeGridMap2D, RealScans)
{
#ifdef MRPT_MAPCONV_SHARED_DIR
  const std::string path = std::string(MRPT_MAPCONV_SHARED_DIR) + "/vlp16_3scans.rawlog";
#else
  const std::string path;
#endif
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no vlp16_3scans.rawlog";
  // a VLP-16 1.8 m up, walls all around at about 2 m; it sees from 1 m to 2.5 m of height
  auto map = mapForRooms(0.05);
  map.scanInsertionOptions.profile.objectMaxZ = 2;
  map.scanInsertionOptions.profile.structureMinZ = 2.1;
  map.scanInsertionOptions.profile.structureMaxZ = 2.6;
  maps::RawlogOptions standing;
  standing.staticSensor = true;
  for (const auto& scan : maps::readRawlog(path, standing))
  {
    const auto before = bytes(*scan.observation);
    ASSERT_TRUE(map.insertObservation(*scan.observation, scan.robotPose));
    EXPECT_EQ(bytes(*scan.observation), before);
    EXPECT_GT(map.lastScan().points, 6000u);
    EXPECT_GT(map.lastScan().shareWithWall(), 0.3);
  }
  EXPECT_GT(countCells(map, [](int cell) { return cell > 0; }), 1000u);
  EXPECT_GT(countCells(map, [](int cell) { return cell < 0; }), 200u);
  const double twice = 1 / (1 + std::exp(-2 * scan::LogOddsUpdate().miss() / 16.0));
  EXPECT_GT(map.getPos(0.55f, 0.55f), twice - 0.01);  // free around the robot
}
