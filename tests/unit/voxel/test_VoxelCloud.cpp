// The points of a voxel map, against OctoMap's own leaves.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelCloud.h>
#include <octomap/octomap.h>

#include <array>
#include <random>
#include <set>

namespace
{
using namespace mrpt_mapconv;
using Places = std::multiset<std::array<double, 3>>;

Places pointsOf(const octomap::OcTree& tree)
{
  const cloud::PointCloud cloud =
      voxel::occupiedCentres(voxel::OctreeSource<octomap::OcTree>(tree));
  EXPECT_EQ(cloud.x.size(), cloud.y.size());
  EXPECT_EQ(cloud.x.size(), cloud.z.size());
  Places places;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    places.insert({cloud.x[i], cloud.y[i], cloud.z[i]});
  return places;
}

/** Of all voxels whose leaf is occupied. */
Places occupiedIn(octomap::OcTree tree)
{
  tree.expand();
  Places places;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf)
    if (tree.isNodeOccupied(*leaf)) places.insert({leaf.getX(), leaf.getY(), leaf.getZ()});
  return places;
}
}  // namespace

TEST(VoxelCloud, HasTheCentreOfEachOccupiedVoxelOnce)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> key(-70, 70), heightKey(-150, 150);
    octomap::OcTree tree(0.25);
    for (int i = 0; i < 3000; ++i)
      tree.updateNode(octomap::OcTreeKey(static_cast<octomap::key_type>(32768 + key(random)),
                                         static_cast<octomap::key_type>(32768 + key(random)),
                                         static_cast<octomap::key_type>(32768 + heightKey(random))),
                      i % 3 != 0);
    const Places right = occupiedIn(tree);
    EXPECT_GT(right.size(), 1000U);
    EXPECT_TRUE(right == pointsOf(tree));
  }
}

TEST(VoxelCloud, APrunedLeafIsAllItsVoxels)
{
  octomap::OcTree tree(0.5);
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z)
        tree.setNodeValue(0.25 + 0.5 * x, 0.25 + 0.5 * y, 0.25 + 0.5 * z, 2.0F);
  tree.prune();
  ASSERT_EQ(tree.getNumLeafNodes(), 1U);
  const Places points = pointsOf(tree);
  EXPECT_EQ(points.size(), 64U);
  EXPECT_EQ(*points.begin(), (std::array<double, 3>{0.25, 0.25, 0.25}));
  EXPECT_EQ(*points.rbegin(), (std::array<double, 3>{1.75, 1.75, 1.75}));
}

TEST(VoxelCloud, OfAMapWithoutAnOccupiedVoxelIsEmpty)
{
  octomap::OcTree tree(0.5);
  EXPECT_TRUE(pointsOf(tree).empty());
  tree.updateNode(1.0, 1.0, 1.0, false);
  EXPECT_TRUE(pointsOf(tree).empty());
}
