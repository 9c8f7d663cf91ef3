#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/LeafProbabilities.h>
#include <octomap/octomap.h>

#include <sstream>

namespace
{
using mrpt_mapconv::voxel::holdsProbabilities;

TEST(LeafProbabilities, AreLostInABtFile)
{
  octomap::OcTree tree(0.1);
  EXPECT_FALSE(holdsProbabilities(tree));
  tree.updateNode(octomap::point3d(1, 1, 1), true);
  tree.updateNode(octomap::point3d(2, 1, 1), false);
  EXPECT_TRUE(holdsProbabilities(tree));
  std::stringstream bytes;
  ASSERT_TRUE(tree.writeBinary(bytes));
  octomap::OcTree read(0.1);
  ASSERT_TRUE(read.readBinary(bytes));
  EXPECT_EQ(2u, read.getNumLeafNodes());
  EXPECT_FALSE(holdsProbabilities(read));
}
}  // namespace
