// Octrees to bricks and back: what cannot be, and how that is told.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/ColorOcTree.h>
#include <octomap/CountingOcTree.h>

#include "oracle/DenseMap.h"
#include "support/KnownVoxels.h"
#include "support/TempDir.h"

namespace
{
using namespace mrpt_mapconv;
using mrpt_mapconv::testing::contains;
using mrpt_mapconv::testing::messageOf;
using mrpt_mapconv::testing::readBytes;
using mrpt_mapconv::testing::TempDir;
using oracle::octomapKey;
using voxel::VoxelGrid;

/** A tree with one leaf of 2^(16 - depth) voxels to a side. */
octomap::OcTree treeOfALeaf(unsigned depth)
{
  octomap::OcTree tree(0.1);
  tree.setNodeValue(octomapKey(-1, -1, -1), 0.5f);
  auto* node = tree.getRoot();
  for (unsigned d = 0; d < depth; ++d)
    node = tree.createNodeChild(node, d == 0 ? 7 : 0);  // from the middle on
  node->setLogOdds(-0.5f);
  return tree;
}

void expectOneLine(const std::string& message)
{
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(OcTreeCopy, TheEndsOfAnOctreesRangeAreHeld)
{
  VoxelGrid grid(0.1);
  grid.set({-32768, 32767, -32768}, -1);
  grid.set({32767, -32768, 32767}, 1);
  const auto tree = voxel::toOcTree(grid);
  EXPECT_TRUE(test::sameVoxels(grid, *tree));
  EXPECT_TRUE(test::sameVoxels(voxel::toVoxelGrid(*tree), grid));
}

TEST(OcTreeCopy, AGridBeyondAnOctreesRangeIsOneClearLine)
{
  const TempDir dir;
  for (const voxel::VoxelKey& beyond :
       {voxel::VoxelKey{32768, 0, 0}, {0, -32769, 0}, {0, 0, INT32_MAX}, {INT32_MIN, 0, 0}})
  {
    VoxelGrid grid(0.1);
    grid.set({0, 0, 0}, 1);
    grid.set(beyond, 1);
    const auto message = messageOf([&] { voxel::toOcTree(grid); });
    expectOneLine(message);
    EXPECT_TRUE(contains(message, "-32768 to 32767")) << message;
    EXPECT_EQ(messageOf([&] { voxel::fullOctree(grid); }), message);
    EXPECT_EQ(messageOf([&] { voxel::writeOctreeFile(dir.path("map.bt"), grid); }), message);
    EXPECT_EQ(dir.entries(), 0u);
  }
}

TEST(OcTreeCopy, AnEmptyGridIsAnEmptyTree)
{
  VoxelGrid grid(0.1);
  grid.set({1, 2, 3}, 1);
  grid.set({1, 2, 3}, voxel::kUntouched);
  EXPECT_EQ(voxel::toOcTree(grid)->size(), 0u);
  EXPECT_TRUE(voxel::readVoxelGrid(voxel::fullOctree(grid), "memory").empty());
  EXPECT_TRUE(voxel::toVoxelGrid(octomap::OcTree(0.1)).empty());
}

TEST(OcTreeCopy, ALeafThatIsTooLargeForBricksIsOneClearLine)
{
  for (const unsigned depth : {2u, 4u})  // 16384 and 4096 voxels to a side
  {
    const auto tree = treeOfALeaf(depth);
    for (const auto& message :
         {messageOf([&] { voxel::toVoxelGrid(tree, 100); }),
          messageOf([&] { voxel::readVoxelGrid(voxel::fullOctree(tree), "map.ot", 100); })})
    {
      expectOneLine(message);
      EXPECT_TRUE(contains(message, std::to_string(1 << (16 - depth)) + " voxels a side"))
          << message;
      EXPECT_TRUE(contains(message, "voxelEngine = octomap")) << message;
    }
    EXPECT_TRUE(
        contains(messageOf([&] { voxel::readVoxelGrid(voxel::fullOctree(tree), "map.ot", 100); }),
                 "map.ot: "));
  }
}

TEST(OcTreeCopy, ALargeLeafThatFitsIsHeld)
{
  const auto tree = treeOfALeaf(6);  // 1024 voxels to a side
  const VoxelGrid grid = voxel::toVoxelGrid(tree, 100);
  EXPECT_EQ(grid.size(), (std::size_t{1} << 30) + 1);
  EXPECT_EQ(grid.logOdds({1023, 0, 1023}), -0.5f);
  EXPECT_FALSE(voxel::isTouched(grid.logOdds({1024, 0, 0})));
  EXPECT_TRUE(voxel::fullOctree(grid) == voxel::fullOctree(*voxel::toOcTree(grid)));
  EXPECT_EQ(voxel::toOcTree(grid)->getNumLeafNodes(), tree.getNumLeafNodes());
}

TEST(OcTreeCopy, ManySmallLeavesThatNeedTooMuchMemoryAreOneClearLine)
{
  octomap::OcTree tree(0.1);
  for (int i = 0; i < 100; ++i) tree.setNodeValue(octomapKey(100 * i, 0, 0), 0.5f);
  const auto message = messageOf([&] { voxel::toVoxelGrid(tree, 1); });
  expectOneLine(message);
  EXPECT_TRUE(contains(message, "maxMemory = 1 MB")) << message;
  EXPECT_EQ(voxel::toVoxelGrid(tree, 3).size(), 100u);
}

TEST(OcTreeCopy, WhatFitsIsHeldThoughEveryLeafCouldHaveNeededARegion)
{
  VoxelGrid grid(0.1);
  for (int x = 0; x < 384; x += 32)
    for (int y = 0; y < 128; y += 32)
      for (int z = 0; z < 128; z += 32)
        grid.fillCube({x, y, z}, 32, (x + y + z) % 64 == 0 ? 0.5f : -0.5f);
  const auto tree = voxel::toOcTree(grid);
  EXPECT_EQ(tree->getNumLeafNodes(), 192u);  // of 8 kB each
  EXPECT_EQ(voxel::toVoxelGrid(*tree, 1).size(), grid.size());
}

TEST(OcTreeCopy, EqualVoxelsOfATreeThatIsNotPrunedBecomeOneValue)
{
  VoxelGrid grid(0.1);
  grid.fillCube({-16, 0, 16}, 16, 0.5f);
  const auto tree = voxel::toOcTree(grid, false);
  EXPECT_EQ(tree->getNumLeafNodes(), 4096u);
  EXPECT_EQ(voxel::toVoxelGrid(*tree).heapBytes(), grid.heapBytes());
  EXPECT_LT(grid.heapBytes(), sizeof(VoxelGrid::Brick));
}

/** −0 stands for a voxel that was never touched. */
TEST(OcTreeCopy, MinusZeroBecomesZero)
{
  octomap::OcTree tree(0.1);
  tree.setNodeValue(octomapKey(1, 2, 3), -0.0f);
  for (const auto& grid :
       {voxel::toVoxelGrid(tree), voxel::readVoxelGrid(voxel::fullOctree(tree), "memory")})
  {
    EXPECT_EQ(grid.size(), 1u);
    EXPECT_EQ(test::bitsOf(grid.logOdds({1, 2, 3})), 0u);
  }
}

TEST(OcTreeCopy, TreesWithoutOccupancyAreNamed)
{
  octomap::CountingOcTree tree(0.1);
  tree.updateNode(octomap::point3d(0, 0, 0));
  const auto message = messageOf<std::invalid_argument>([&] { voxel::toVoxelGrid(tree); });
  EXPECT_TRUE(contains(message, tree.getTreeType())) << message;
}

TEST(OcTreeCopy, BytesOfOtherTreesAndKindsAreNamed)
{
  octomap::ColorOcTree color(0.1);
  color.updateNode(octomap::point3d(0, 0, 0), true);
  EXPECT_EQ(messageOf([&] { voxel::readVoxelGrid(voxel::fullOctree(color), "map.ot"); }),
            "map.ot: holds a ColorOcTree where an OcTree belongs");
  const TempDir dir;
  voxel::writeOctreeFile(dir.path("map.bt"), color);
  EXPECT_EQ(messageOf([&] { voxel::readVoxelGrid(readBytes(dir.path("map.bt")), "map.bt"); }),
            "map.bt: is a binary octree (.bt) where a full one belongs");
  octomap::OcTree coarse(5000);
  coarse.updateNode(octomap::point3d(0, 0, 0), true);
  const auto message =
      messageOf([&] { voxel::readVoxelGrid(voxel::fullOctree(coarse), "map.ot"); });
  EXPECT_TRUE(contains(message, "map.ot: ") && contains(message, "5000")) << message;
}

}  // namespace
