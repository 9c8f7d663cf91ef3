#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/VoxelGridSource.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <mrpt_mapconv/voxel/VoxelMap.h>
#include <octomap/OcTree.h>

#include <limits>
#include <stdexcept>
#include <string>

using namespace mrpt_mapconv;
using voxel::TVoxelInsertionOptions;
using voxel::VoxelGrid;
using voxel::VoxelMap;

namespace
{
const observation::SensorPoints kScan{mrpt::poses::CPose3D(0.05, 0.05, 0.05, 0, 0, 0),
                                      {{4, 1, 0}, {3, -2, 1}}};

/** A tree of a leaf of 16384 voxels a side and of a voxel beside it. */
octomap::OcTree hugeLeaf()
{
  octomap::OcTree tree(0.1);
  tree.updateNode(octomap::OcTreeKey(1, 1, 1), true);
  auto* node = tree.getRoot();
  node = tree.createNodeChild(tree.createNodeChild(node, 7), 0);
  node->setLogOdds(-1);
  return tree;
}
}  // namespace

TEST(VoxelMapLimits, AStreamWithAHugeLeafIsKeptAsAnOctree)
{
  const auto tree = hugeLeaf();
  VoxelMap map(0.1);
  map.setFullOctree(voxel::fullOctree(tree), "stream", 0.1);
  EXPECT_TRUE(map.octree() == tree);
  EXPECT_THROW(map.insertScan(kScan, {}), std::runtime_error);
  EXPECT_TRUE(map.octree() == tree);
  TVoxelInsertionOptions octomap;
  octomap.voxelEngine = voxel::VoxelEngine::Octomap;
  EXPECT_FALSE(map.insertScan(kScan, octomap).empty());
}

TEST(VoxelMapLimits, WhatWasPrunedOnceStaysPruned)
{
  auto tree = std::make_unique<octomap::OcTree>(0.1);
  const auto key = [](int above) { return static_cast<octomap::key_type>(40000 + above); };
  for (int i = 0; i < 512; ++i)
    tree->updateNode(octomap::OcTreeKey(key(i & 7), key(i >> 3 & 7), key(i >> 6)), true);
  EXPECT_EQ(tree->getNumLeafNodes(), 1u);
  VoxelMap map(0.1);
  map.setOctree(std::move(tree));
  TVoxelInsertionOptions unpruned;
  unpruned.pruning = false;
  map.insertScan(kScan, unpruned);
  EXPECT_LT(map.octree().getNumLeafNodes(), 200u);

  VoxelMap fromScans(0.1);
  fromScans.insertScan(kScan, unpruned);
  fromScans.insertScan(kScan, unpruned);
  EXPECT_FALSE(fromScans.model().pruning);
}

TEST(VoxelMapLimits, OptionsThatAreNotValidAreRefused)
{
  TVoxelInsertionOptions bad;
  bad.maxMemory = -5;
  VoxelMap map(0.1);
  VoxelGrid grid(0.1);
  octomap::OcTree tree(0.1);
  EXPECT_THROW(map.insertScan(kScan, bad), std::invalid_argument);
  EXPECT_THROW(voxel::insertScan(grid, kScan, bad), std::invalid_argument);
  EXPECT_THROW(voxel::insertScan(tree, kScan, bad), std::invalid_argument);
  tree.updateNode(octomap::OcTreeKey(1, 1, 1), true);
  EXPECT_THROW(voxel::toVoxelGrid(tree, -5), std::invalid_argument);
  EXPECT_TRUE(map.empty());
  EXPECT_TRUE(grid.empty());
  bad = {};
  bad.clampingThresMin = 0.9;
  bad.clampingThresMax = 0.2;
  EXPECT_THROW(voxel::insertScan(grid, kScan, bad), std::invalid_argument);
}

TEST(VoxelMapLimits, ATreeOfAResolutionThatNoMapHasIsRefused)
{
  VoxelMap map(0.1);
  EXPECT_THROW(map.setOctree(std::make_unique<octomap::OcTree>(1e-5)), std::invalid_argument);
  EXPECT_THROW(map.setOctree(nullptr), std::invalid_argument);
  EXPECT_EQ(map.resolution(), 0.1);
}

TEST(VoxelMapLimits, RegionsWithoutAVoxelAreNotInTheOctree)
{
  VoxelGrid grid(0.1);
  grid.set({1, 2, 3}, 1);
  grid.set({1 << 20, 0, 0}, 1);
  grid.set({1 << 20, 0, 0}, voxel::kUntouched);
  grid.table().obtain(voxel::regionKey({1 << 21, 0, 0}));
  for (auto& slot : grid.table().obtain(voxel::regionKey({1 << 20, 0, 0}))) slot.collapse();
  EXPECT_EQ(voxel::toOcTree(grid)->getNumLeafNodes(), 1u);
}

TEST(VoxelMapLimits, AMapThatNoFrameCouldHoldSaysSo)
{
  VoxelGrid grid(0.1);
  constexpr auto lowest = std::numeric_limits<std::int32_t>::min();
  grid.set({lowest, 5, 0}, 1);
  const auto box = voxel::VoxelGridSource(grid).bounds();
  ASSERT_TRUE(box);
  EXPECT_EQ(box->xMin, lowest);
  EXPECT_EQ(box->xMax, lowest);
  grid.set({5, 5, 0}, 1);
  EXPECT_THROW(voxel::VoxelGridSource(grid).bounds(), std::runtime_error);
  EXPECT_EQ(grid.size(), 2u);
}

TEST(VoxelMapLimits, WhatAGridTakesIsNeverMoreThanWasAnnounced)
{
  VoxelMap map(0.1);
  VoxelGrid grid(0.1);
  for (int i = 0; i < 5; ++i)
  {
    auto scan = kScan;
    scan.sensorPose.x(3.0 * i);
    voxel::insertScan(grid, scan, {});
    EXPECT_LE(grid.heapBytes(), grid.heapBytesAtMost());
  }
  grid.set({500, 0, 0}, 1);
  grid.fillCube({1024, 0, 0}, 256, -1);
  EXPECT_LE(grid.heapBytes(), grid.heapBytesAtMost());
  const VoxelGrid copy = grid;
  EXPECT_LE(copy.heapBytes(), copy.heapBytesAtMost());
  grid.countHeapBytes();
  EXPECT_EQ(grid.heapBytes(), grid.heapBytesAtMost());
  grid.clear();
  EXPECT_EQ(grid.heapBytesAtMost(), 0u);
}
