#include <gtest/gtest.h>
#include <mrpt/maps/CColouredOctoMap.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

using namespace mrpt_mapconv;

TEST(OctoMapAccess, GivesTheTreeInsideAnMrptOctomap)
{
  mrpt::maps::COctoMap map(0.25);
  map.updateVoxel(1.1, 0.1, 0.6, true);
  map.updateVoxel(-1.1, 0.1, 0.6, false);
  const octomap::OcTree& tree = maps::octreeOf(map);
  EXPECT_EQ(tree.getResolution(), 0.25);
  ASSERT_TRUE(tree.search(1.1, 0.1, 0.6));
  EXPECT_TRUE(tree.isNodeOccupied(tree.search(1.1, 0.1, 0.6)));
  ASSERT_TRUE(tree.search(-1.1, 0.1, 0.6));
  EXPECT_FALSE(tree.isNodeOccupied(tree.search(-1.1, 0.1, 0.6)));
  EXPECT_EQ(tree.getNumLeafNodes(), 2u);
}

TEST(OctoMapAccess, GivesTheTreeInsideAColouredOne)
{
  mrpt::maps::CColouredOctoMap map(0.5);
  map.updateVoxel(1.1, 0.1, 0.6, true);
  EXPECT_EQ(maps::octreeOf(map).getNumLeafNodes(), 1u);
  EXPECT_EQ(maps::octreeOf(map).getResolution(), 0.5);
}

TEST(OctoMapAccess, FindsTheFirstTreeInAnObject)
{
  auto octomap = mrpt::maps::COctoMap::Create(0.25);
  mrpt::maps::CMultiMetricMap several;
  several.maps.push_back(mrpt::maps::CSimplePointsMap::Create());
  EXPECT_EQ(maps::octreeIn(several), nullptr);
  several.maps.push_back(octomap);
  EXPECT_EQ(maps::octreeIn(several), &maps::octreeOf(*octomap));

  const CFreeSpaceGridMap2D ours(0.3);
  EXPECT_EQ(maps::octreeIn(ours), &ours.octree());
}

template <class Tree>
void expectSameLeaves(const Tree& tree)
{
  const auto copy = voxel::toOcTree(tree);
  EXPECT_EQ(copy->getResolution(), tree.getResolution());
  EXPECT_EQ(copy->getNumLeafNodes(), tree.getNumLeafNodes());
  EXPECT_EQ(copy->size(), tree.size());
  EXPECT_EQ(copy->size(), copy->calcNumNodes());
  for (auto it = tree.begin_leafs(); it != tree.end_leafs(); ++it)
  {
    const auto* node = copy->search(it.getKey(), it.getDepth());
    ASSERT_TRUE(node);
    EXPECT_EQ(node->getLogOdds(), it->getLogOdds());
    EXPECT_FALSE(copy->nodeHasChildren(node));
  }
}

template <class Tree>
void fill(Tree& tree)
{
  for (unsigned short i = 0; i < 16; ++i)
    for (unsigned short j = 0; j < 16; ++j)
      tree.updateNode(octomap::OcTreeKey(32760 + i, 32768 + j,
                                         static_cast<unsigned short>(32768 + (i * j) % 5)),
                      (i + j) % 3 == 0);
}

TEST(OctoMapAccess, CopiesTheOccupancyOfEveryKindOfTree)
{
  octomap::OcTree plain(0.1);
  fill(plain);
  expectSameLeaves(plain);
  octomap::ColorOcTree color(0.1);
  fill(color);
  expectSameLeaves(color);
  octomap::OcTreeStamped stamped(0.1);
  fill(stamped);
  expectSameLeaves(stamped);
  expectSameLeaves(octomap::ColorOcTree(0.2));  // an empty one
}
