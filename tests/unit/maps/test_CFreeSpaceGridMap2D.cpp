#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <cstring>

#include "FreeSpaceMapFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;

TEST(CFreeSpaceGridMap2D, ANewMapIsEmptyAndUnknown)
{
  const CFreeSpaceGridMap2D map(0.25);
  EXPECT_TRUE(map.isEmpty());
  EXPECT_TRUE(map.layers().frame().empty());
  EXPECT_FLOAT_EQ(map.getResolution(), 0.25f);
  EXPECT_EQ(map.getCell(0, 0), 0.5f);
  EXPECT_THROW(CFreeSpaceGridMap2D(0), std::invalid_argument);
  EXPECT_THROW(CFreeSpaceGridMap2D(-1), std::invalid_argument);
  EXPECT_THROW(CFreeSpaceGridMap2D(std::nan("")), std::invalid_argument);
}

TEST(CFreeSpaceGridMap2D, TheGridShowsTheLayerOfTheRobot)
{
  // by hand: three columns in a row, floor 0, 0 and a cliff of 4 m; a wall beside the first
  octomap::OcTree tree(1.0);
  column(tree, 0, 0, 0, 'f', 3);
  column(tree, 1, 0, 0, 'f', 3);
  column(tree, 2, 0, 0, '#', 4);
  column(tree, 2, 0, 4, 'f', 3);
  column(tree, -1, 0, 0, '#', 3);
  column(tree, 4, 0, 0, '#', 1);  // not next to anything free

  CFreeSpaceGridMap2D map;
  auto options = map.conversionOptions();
  options.params.minClearance = 2;
  options.params.maxStep = 1;
  options.params.floorFrom = freespace::FloorFrom::LowestFree;
  map.setConversionOptions(options);
  map.setVoxelMap(tree);
  EXPECT_FALSE(map.isEmpty());
  ASSERT_EQ(map.getSizeX(), 6u);
  ASSERT_EQ(map.getSizeY(), 1u);
  EXPECT_FLOAT_EQ(map.getXMin(), -1);
  EXPECT_FLOAT_EQ(map.getYMin(), 0);
  // wall | free | step | step | unknown | unknown
  EXPECT_EQ(map.getRawMap(), (std::vector<std::int8_t>{-127, 127, -127, -127, 0, 0}));

  options.robot = freespace::Robot::Aerial;
  map.setConversionOptions(options);
  EXPECT_EQ(map.getRawMap(), (std::vector<std::int8_t>{-127, 127, 127, 127, 0, 0}));
}

TEST(CFreeSpaceGridMap2D, ByDefaultAGroundRobotStandsOnlyOnWhatWasSeen)
{
  // free columns: one over something occupied, two over nothing known
  octomap::OcTree tree(1.0);
  column(tree, 0, 0, -1, '#', 1);
  for (int x = 0; x < 3; ++x) column(tree, x, 0, 0, 'f', 3);
  CFreeSpaceGridMap2D map;
  map.setVoxelMap(tree);
  EXPECT_EQ(map.getRawMap(), (std::vector<std::int8_t>{127, 0, 0}));
}

TEST(CFreeSpaceGridMap2D, InsertingScansGivesWhatAFullConversionGives)
{
  for (const auto robot : {freespace::Robot::Ground, freespace::Robot::Aerial})
  {
    CFreeSpaceGridMap2D map(0.2);
    auto options = map.conversionOptions();
    options.robot = robot;
    options.params.minClearance = 0.6;
    map.setConversionOptions(options);
    for (int i = 0; i < 6; ++i)
      ASSERT_TRUE(map.insertObservation(roomScan(i), mrpt::poses::CPose3D(0.7 * i, 0.3 * i, 1)));

    const voxel::OctreeSource<octomap::OcTree> source(map.octree());
    const auto full = freespace::convert(source, options.params, 1);
    expectSameBits(map.exactLayers(), full);
    const auto& shown =
        robot == freespace::Robot::Ground ? map.layers().ground : map.layers().aerial;
    ASSERT_EQ(map.getRawMap().size(), shown.cells().size());
    for (std::size_t i = 0; i < shown.cells().size(); ++i)
      ASSERT_EQ(map.getRawMap()[i], grid::rawGridCell(shown.cells()[i])) << i;
    EXPECT_GT(freespace::statistics(full).free, 100u);
    EXPECT_GT(freespace::statistics(full).occupied, 10u);
  }
}

TEST(CFreeSpaceGridMap2D, AGridResizedBehindItsBackIsLaidOutAnew)
{
  CFreeSpaceGridMap2D map(0.2);
  map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1));
  map.resizeGrid(-50, 50, -50, 50);
  map.insertObservation(roomScan(1), mrpt::poses::CPose3D(0.2, 0, 1));
  EXPECT_EQ(map.getSizeX(), static_cast<unsigned>(map.layers().frame().width));
  EXPECT_EQ(map.getSizeY(), static_cast<unsigned>(map.layers().frame().height));
  for (std::size_t i = 0; i < map.getRawMap().size(); ++i)
    ASSERT_EQ(map.getRawMap()[i], grid::rawGridCell(map.layers().ground.cells()[i]));
}

TEST(CFreeSpaceGridMap2D, OtherObservationsAnd2DScansOnRequestAreIgnored)
{
  CFreeSpaceGridMap2D map(0.2);
  EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservationRange(), mrpt::poses::CPose3D()));
  mrpt::obs::CObservation2DRangeScan scan;
  scan.resizeScan(11);
  scan.aperture = 1;
  for (std::size_t i = 0; i < 11; ++i)
  {
    scan.setScanRange(i, 3);
    scan.setScanRangeValidity(i, true);
  }
  map.voxelInsertionOptions.insert2D = false;
  EXPECT_FALSE(map.insertObservation(scan, mrpt::poses::CPose3D()));
  EXPECT_TRUE(map.isEmpty());
  map.voxelInsertionOptions.insert2D = true;
  EXPECT_TRUE(map.insertObservation(scan, mrpt::poses::CPose3D()));
  EXPECT_FALSE(map.isEmpty());
}

TEST(CFreeSpaceGridMap2D, ABadPoseOrOptionThrowsAndTheMapStaysAsItWas)
{
  CFreeSpaceGridMap2D map(0.2);
  map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1));
  const auto before = map.exactLayers();
  EXPECT_ANY_THROW(
      map.insertObservation(roomScan(1), mrpt::poses::CPose3D(std::nan(""), 0, 0, 0, 0, 0)));
  map.voxelInsertionOptions.probHit = 7;
  EXPECT_ANY_THROW(map.insertObservation(roomScan(1), mrpt::poses::CPose3D(0, 0, 1)));
  auto options = map.conversionOptions();
  options.params.slopeWindow = 0;
  EXPECT_THROW(map.setConversionOptions(options), std::invalid_argument);
  map.voxelInsertionOptions = {};
  EXPECT_THROW(map.loadVoxelMap("/nowhere/map.bt"), std::runtime_error);
  EXPECT_THROW(map.setVoxelMap(std::unique_ptr<octomap::OcTree>()), std::invalid_argument);
  expectSameBits(map.exactLayers(), before);
  EXPECT_EQ(map.conversionOptions().params.slopeWindow, 2);
}

TEST(CFreeSpaceGridMap2D, ClearForgetsTheVoxelsAndKeepsTheOptions)
{
  CFreeSpaceGridMap2D map(0.2);
  auto options = map.conversionOptions();
  options.params.minClearance = 0.6;
  map.setConversionOptions(options);
  map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1));
  map.clear();
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.octree().size(), 0u);
  EXPECT_TRUE(map.layers().frame().empty());
  EXPECT_EQ(map.conversionOptions().params.minClearance, 0.6);
  EXPECT_FLOAT_EQ(map.getResolution(), 0.2f);
  map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1));
  EXPECT_FALSE(map.isEmpty());
}

TEST(CFreeSpaceGridMap2D, TakesAnMrptOctomap)
{
  mrpt::maps::COctoMap octomap(0.5);
  for (int x = 0; x < 4; ++x)
    for (int z = -1; z < 3; ++z)
      octomap.updateVoxel(x * 0.5 + 0.1, 0.1, z * 0.5 + 0.1, x == 3 || z < 0);
  CFreeSpaceGridMap2D map(0.1);
  map.setVoxelMap(octomap);
  EXPECT_FLOAT_EQ(map.getResolution(), 0.5f);
  EXPECT_EQ(map.getRawMap(), (std::vector<std::int8_t>{127, 127, 127, -127}));
}

TEST(CFreeSpaceGridMap2D, ACopyIsIndependent)
{
  CFreeSpaceGridMap2D map(0.2);
  map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1));
  CFreeSpaceGridMap2D copy(map), assigned(0.7);
  assigned = map;
  const auto before = map.exactLayers();
  map.insertObservation(roomScan(3), mrpt::poses::CPose3D(2, 1, 1));
  expectSameBits(copy.exactLayers(), before);
  expectSameBits(assigned.exactLayers(), before);
  for (auto* other : {&copy, &assigned})
  {
    other->insertObservation(roomScan(3), mrpt::poses::CPose3D(2, 1, 1));
    expectSameBits(other->layers(), map.layers());
    EXPECT_EQ(other->getRawMap(), map.getRawMap());
  }
}

TEST(CFreeSpaceGridMap2D, AScanTooLargeForTheLayersIsRefusedAndTheMapStaysAsItWas)
{
  CFreeSpaceGridMap2D map(0.01);
  auto near = mrpt::maps::CSimplePointsMap::Create();
  near->insertPoint(0.5f, 0, 0);
  mrpt::obs::CObservationPointCloud scan;
  scan.pointcloud = near;
  ASSERT_TRUE(map.insertObservation(scan, mrpt::poses::CPose3D()));
  const auto before = map.exactLayers();
  const auto nodes = map.octree().size();

  auto far = mrpt::maps::CSimplePointsMap::Create();  // 300 m × 300 m of 1 cm: 9·10^8 cells
  far->insertPoint(300, 0, 0);
  far->insertPoint(0, 300, 0);
  scan.pointcloud = far;
  EXPECT_THROW(map.insertObservation(scan, mrpt::poses::CPose3D()), std::exception);
  expectSameBits(map.exactLayers(), before);
  EXPECT_EQ(map.octree().size(), nodes);
}

TEST(CFreeSpaceGridMap2D, AVoxelMapWithoutFreeVoxelsIsNamedWithWhatHelps)
{
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  CFreeSpaceGridMap2D map;
  octomap::OcTree tree(0.2);
  column(tree, 0, 0, 0, '#', 2);
  map.setVoxelMap(tree);
  const auto said = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("unknown = free"), std::string::npos) << said;
}

TEST(CFreeSpaceGridMap2D, WarnsOnceWhenNothingIsFreeAndNamesMinClearance)
{
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  CFreeSpaceGridMap2D map(0.2);
  mrpt::obs::CObservation2DRangeScan scan;  // one voxel high
  scan.resizeScan(11);
  scan.aperture = 1;
  for (std::size_t i = 0; i < 11; ++i)
  {
    scan.setScanRange(i, 3);
    scan.setScanRangeValidity(i, true);
  }
  map.insertObservation(scan, mrpt::poses::CPose3D());
  map.insertObservation(scan, mrpt::poses::CPose3D(0.5, 0, 0));
  const auto said = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  const auto first = said.find("minClearance = 1");
  EXPECT_NE(first, std::string::npos) << said;
  EXPECT_EQ(said.find("minClearance", first + 1), std::string::npos) << said;
}
