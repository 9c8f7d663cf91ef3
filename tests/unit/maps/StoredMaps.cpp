#include "StoredMaps.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <octomap/OcTree.h>

namespace mrpt_mapconv::fixtures
{
namespace
{
using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;

/** A scan without a time: what goes into a map must not depend on one. */
mrpt::obs::CObservationPointCloud scanOf(const std::vector<TPoint3Df>& points, const CPose3D& pose)
{
  mrpt::obs::CObservationPointCloud scan;
  scan.sensorLabel = "LIDAR";
  scan.sensorPose = pose;
  scan.pointcloud = mrpt::maps::CSimplePointsMap::Create();
  for (const auto& point : points) scan.pointcloud->insertPoint(point);
  return scan;
}

void setOptions(CFreeSpaceGridMap2D& map)
{
  freespace::TConversionOptions conversion;
  conversion.robot = freespace::Robot::Aerial;
  conversion.params.minClearance = 0.75;
  conversion.params.minOccupancy = 0.25;
  conversion.params.slopeWindow = 1;
  conversion.params.maxSlope = 0.5;
  conversion.params.maxStep = 0.375;
  conversion.params.floorFrom = freespace::FloorFrom::LowestFree;
  map.setConversionOptions(conversion);
  map.voxelInsertionOptions.maxrange = 4;
  map.voxelInsertionOptions.pruning = false;
  map.voxelInsertionOptions.occupancyThres = 0.625;
  map.voxelInsertionOptions.probHit = 0.75;
  map.voxelInsertionOptions.probMiss = 0.375;
  map.voxelInsertionOptions.clampingThresMin = 0.1875;
  map.voxelInsertionOptions.clampingThresMax = 0.9375;
  map.voxelInsertionOptions.insert2D = false;
  map.renderingOptions.showFloor = false;
  map.renderingOptions.showCeiling = true;
  map.renderingOptions.colorBySlope = true;
}

void setOptions(CScanShapeGridMap2D& map)
{
  map.maxGridCells = 1e6;
  auto& profile = map.scanInsertionOptions.profile;
  profile.model = scan::Model::ClosestPoint;
  profile.objectMinZ = 0.125;
  profile.objectMaxZ = 1.25;
  profile.reflectionFilter = false;
  profile.structureMinZ = 2;
  profile.structureMaxZ = 2.25;
  profile.minRange = 0.5;
  profile.maxRange = 8;
  profile.sectors = 4;
  profile.structureGap = 0.0625;
  profile.structureTolerance = 0.375;
  auto& update = map.scanInsertionOptions.update;
  update.pHit = 0.75;
  update.pMiss = 0.375;
  update.pMin = 0.0625;
  update.pMax = 0.9375;
  map.scanInsertionOptions.insert2D = false;
}

template <class Map>
void insert(const mrpt::obs::CObservation& scan, const CPose3D& robot, Map& map)
{
  EXPECT_TRUE(map.insertObservation(scan, robot)) << robot;
}

template <class Map>
std::shared_ptr<Map> shared(const Map& map)
{
  return std::make_shared<Map>(map);
}
}  // namespace

CFreeSpaceGridMap2D storedFreeSpaceMap()
{
  CFreeSpaceGridMap2D map(0.5);
  setOptions(map);
  const auto scan = scanOf({{0, 0, -1.5f}, {0, 0, 1}, {1, 0, 0}, {-2, 0, 0}, {0, 8, 0}},
                           CPose3D(0.25, 0.25, 1.75, 0, 0, 0));
  insert(scan, CPose3D(0, 0, 0, 0, 0, 0), map);
  insert(scan, CPose3D(0.5, 0, 0, 0, 0, 0), map);
  insert(scan, CPose3D(0, 0.5, 0.5, 0, 0, 0), map);
  setGridOptions(map);  // at last: they forbid to insert
  return map;
}

CScanShapeGridMap2D storedScanShapeMap()
{
  CScanShapeGridMap2D map(0.25);
  map.log().logging_enable_console_output = false;
  setOptions(map);
  for (const float x : {0.0f, 0.25f, 0.5f})
  {
    // cells' centres less the sensor's place, so that all numbers are exact
    const auto scan = scanOf(
        {{2 - x, 0, -0.5f}, {3 - x, 0, 0.125f}, {-x, 1.5f, 0}, {-1.5f - x, 0, -0.25f}, {0, 4, 2}},
        CPose3D(0.125, 0.125, 1, 0, 0, 0));
    insert(scan, CPose3D(static_cast<double>(x), 0, 0, 0, 0, 0), map);
  }
  setGridOptions(map);  // at last: they forbid to insert
  return map;
}

const std::vector<StoredStream>& storedStreams()
{
  static const std::vector<StoredStream> streams = {
      {"freespace_empty.bin", [] { return std::make_shared<CFreeSpaceGridMap2D>(); }},
      {"freespace_scans.bin", [] { return shared(storedFreeSpaceMap()); }},
      {"scanshape_empty.bin", [] { return std::make_shared<CScanShapeGridMap2D>(); }},
      {"scanshape_scans.bin", [] { return shared(storedScanShapeMap()); }},
      {"terrain_empty.bin", [] { return std::make_shared<CTerrainGridMap2D>(); }},
      {"terrain_scans.bin", [] { return shared(storedTerrainMap()); }},
      {"multimetric.bin", []
       {
         auto both = std::make_shared<mrpt::maps::CMultiMetricMap>();
         both->maps.push_back(shared(storedFreeSpaceMap()));
         both->maps.push_back(shared(storedScanShapeMap()));
         return both;
       }}};
  return streams;
}

void expectStoredFreeSpaceOptions(const CFreeSpaceGridMap2D& map)
{
  const freespace::TConversionOptions& conversion = map.conversionOptions();
  EXPECT_EQ(freespace::Robot::Aerial, conversion.robot);
  EXPECT_EQ(0.75, conversion.params.minClearance);
  EXPECT_EQ(0.25, conversion.params.minOccupancy);
  EXPECT_EQ(1, conversion.params.slopeWindow);
  EXPECT_EQ(0.5, conversion.params.maxSlope);
  EXPECT_EQ(0.375, conversion.params.maxStep);
  EXPECT_EQ(freespace::FloorFrom::LowestFree, conversion.params.floorFrom);
  EXPECT_EQ(4, map.voxelInsertionOptions.maxrange);
  EXPECT_FALSE(map.voxelInsertionOptions.pruning);
  EXPECT_EQ(0.625, map.voxelInsertionOptions.occupancyThres);
  EXPECT_EQ(0.75, map.voxelInsertionOptions.probHit);
  EXPECT_EQ(0.375, map.voxelInsertionOptions.probMiss);
  EXPECT_EQ(0.1875, map.voxelInsertionOptions.clampingThresMin);
  EXPECT_EQ(0.9375, map.voxelInsertionOptions.clampingThresMax);
  EXPECT_FALSE(map.voxelInsertionOptions.insert2D);
  EXPECT_FALSE(map.renderingOptions.showFloor);
  EXPECT_TRUE(map.renderingOptions.showCeiling);
  EXPECT_TRUE(map.renderingOptions.colorBySlope);
  EXPECT_NEAR(0.75, map.octree().getProbHit(), 1e-6) << "the tree's own sensor model";
  EXPECT_NEAR(0.625, map.octree().getOccupancyThres(), 1e-6);
  expectGridOptions(map);
}

void expectStoredScanShapeOptions(const CScanShapeGridMap2D& map)
{
  EXPECT_EQ(1e6, map.maxGridCells);
  const auto& profile = map.scanInsertionOptions.profile;
  EXPECT_EQ(scan::Model::ClosestPoint, profile.model);
  EXPECT_EQ(0.125, profile.objectMinZ);
  EXPECT_EQ(1.25, profile.objectMaxZ);
  EXPECT_FALSE(profile.reflectionFilter);
  EXPECT_EQ(2, profile.structureMinZ);
  EXPECT_EQ(2.25, profile.structureMaxZ);
  EXPECT_EQ(0.5, profile.minRange);
  EXPECT_EQ(8, profile.maxRange);
  EXPECT_EQ(4, profile.sectors);
  EXPECT_EQ(0.0625, profile.structureGap);
  EXPECT_EQ(0.375, profile.structureTolerance);
  const auto& update = map.scanInsertionOptions.update;
  EXPECT_EQ(0.75, update.pHit);
  EXPECT_EQ(0.375, update.pMiss);
  EXPECT_EQ(0.0625, update.pMin);
  EXPECT_EQ(0.9375, update.pMax);
  EXPECT_FALSE(map.scanInsertionOptions.insert2D);
  expectGridOptions(map);
}

}  // namespace mrpt_mapconv::fixtures
