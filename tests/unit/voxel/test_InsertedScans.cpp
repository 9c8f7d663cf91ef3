#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <memory>

#include "support/ScanFixtures.h"

using namespace mrpt_mapconv;
using observation::PosedObservation;
using voxel::insertScans;
using voxel::TVoxelInsertionOptions;

namespace
{
const mrpt::poses::CPose3D kRobot(0.5, 0.5, 0.5, 0, 0, 0);

/** A 3D scan of points, as seen from the robot. */
PosedObservation cloud(const std::vector<mrpt::math::TPoint3Df>& points,
                       const mrpt::poses::CPose3D& robot = kRobot)
{
  auto map = mrpt::maps::CSimplePointsMap::Create();
  for (const auto& point : points) map->insertPoint(point.x, point.y, point.z);
  auto scan = mrpt::obs::CObservationPointCloud::Create();
  scan->pointcloud = map;
  return {scan, robot};
}

/** A 2D scan of one beam, 3 m along y: the middle one of a scanner that looks there. */
PosedObservation beam2D()
{
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->aperture = 0.1f;
  scan->sensorPose = mrpt::poses::CPose3D(0, 0, 0, mrpt::DEG2RAD(90.0), 0, 0);
  scan->resizeScan(3);
  for (std::size_t i = 0; i < 3; ++i)
  {
    scan->setScanRange(i, 3);
    scan->setScanRangeValidity(i, i == 1);
  }
  return {scan, kRobot};
}

bool isOccupied(const octomap::OcTree& tree, double x, double y, double z)
{
  const auto* node = tree.search(x, y, z);
  return node && tree.isNodeOccupied(node);
}
}  // namespace

TEST(InsertedScans, TheTreeIsThatOfTheScansOneByOne)
{
  const std::vector<PosedObservation> scans = {cloud({{4, 0, 0}, {0, 2, 1}}),
                                               cloud({{2, 0, 0}}, {0.5, 3.5, 0.5, 1, 0, 0})};
  octomap::OcTree tree(1.0), oneByOne(1.0);
  const auto inserted = insertScans(tree, scans, {});
  voxel::ColumnSet changed;
  for (const auto& scan : scans)
    changed.insert(voxel::insertScan(
        oneByOne, *observation::sensorPoints(*scan.observation, scan.robotPose), {}));
  EXPECT_TRUE(tree == oneByOne);
  EXPECT_EQ(inserted.scans, 2u);
  EXPECT_EQ(inserted.points, 3u);
  EXPECT_EQ(inserted.changed.size(), changed.size());
  for (int y = -2; y < 8; ++y)
    for (int x = -2; x < 8; ++x)
      EXPECT_EQ(inserted.changed.contains(x, y), changed.contains(x, y)) << x << ' ' << y;
}

TEST(InsertedScans, Scans2DAreInsertedUnlessTheyAreNotWanted)
{
  const std::vector<PosedObservation> scans = {beam2D(), cloud({{4, 0, 0}})};
  for (const bool insert2D : {true, false})
  {
    octomap::OcTree tree(1.0);
    TVoxelInsertionOptions options;
    options.insert2D = insert2D;
    const auto inserted = insertScans(tree, scans, options);
    EXPECT_EQ(inserted.scans, insert2D ? 2u : 1u);
    EXPECT_EQ(isOccupied(tree, 0.5, 3.5, 0.5), insert2D);
    EXPECT_EQ(inserted.changed.contains(0, 3), insert2D);
    EXPECT_TRUE(isOccupied(tree, 4.5, 0.5, 0.5));
  }
}

TEST(InsertedScans, WhatHoldsNoPointsIsPassedOver)
{
  octomap::OcTree tree(1.0);
  const PosedObservation imu = {mrpt::obs::CObservationIMU::Create(), kRobot};
  const auto inserted = insertScans(tree, {imu, cloud({})}, {});
  EXPECT_EQ(inserted.scans, 0u);
  EXPECT_TRUE(inserted.changed.empty());
  EXPECT_EQ(tree.size(), 0u);
}

TEST(InsertedScans, ProgressIsToldBeforeEachScanWhetherItIsUsedOrNot)
{
  octomap::OcTree tree(1.0);
  std::vector<double> told;
  std::vector<std::size_t> sizes;
  insertScans(tree, {cloud({}), beam2D(), cloud({{4, 0, 0}}), cloud({{2, 0, 0}})}, {}, nullptr,
              [&](double share)
              {
                told.push_back(share);
                sizes.push_back(tree.size());
              });
  EXPECT_EQ(told, (std::vector<double>{0, 0.25, 0.5, 0.75}));
  ASSERT_EQ(sizes.size(), 4u);
  EXPECT_EQ(sizes[1], 0u);
  EXPECT_GT(sizes[2], 0u);
}

TEST(InsertedScans, WhatIsWrongWithEveryScanIsSaidOnce)
{
  octomap::OcTree tree(1.0);
  fixtures::Warnings log;
  observation::SayOnceLog warnings(&log);
  const auto scan = cloud({{4, 0, 0}, {NAN, 0, 0}});
  insertScans(tree, {scan, scan, scan}, {}, &warnings);
  ASSERT_EQ(log.texts.size(), 1u);
  EXPECT_NE(log.texts[0].find("NaN or infinite"), std::string::npos) << log.texts[0];
}

TEST(InsertedScans, ABadPoseIsAnErrorAndTheScansBeforeItStay)
{
  octomap::OcTree tree(1.0);
  EXPECT_THROW(
      insertScans(tree, {cloud({{4, 0, 0}}), cloud({{4, 0, 0}}, {NAN, 0, 0, 0, 0, 0})}, {}),
      std::runtime_error);
  EXPECT_TRUE(isOccupied(tree, 4.5, 0.5, 0.5));
}
