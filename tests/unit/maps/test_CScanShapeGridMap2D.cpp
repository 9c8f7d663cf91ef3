#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>

#include <cstring>

#include "ScanShapeFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::poses::CPose3D;

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
  const auto points = observation::sensorPoints(scan, robot);
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

TEST(CScanShapeGridMap2D, WarnsOnceIfTheSlicesOverlap)
{
  const Room room{-3, 3, -2, 2, 2.5};
  for (const bool filter : {true, false})
  {
    auto map = mapForRooms();
    const WarningsOf warnings(map);
    map.scanInsertionOptions.profile.structureMinZ = 1;
    map.scanInsertionOptions.profile.reflectionFilter = filter;
    for (int i = 0; i < 2; ++i)
      ASSERT_TRUE(map.insertObservation(scanOf(room, CPose3D()), CPose3D()));
    ASSERT_EQ(warnings.texts.size(), filter ? 1u : 0u);
    EXPECT_TRUE(!filter || contains(warnings.texts[0], "overlap")) << warnings.texts[0];
  }
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
  observation::RawlogOptions standing;
  standing.staticSensor = true;
  for (const auto& scan : observation::readRawlog(path, standing))
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
