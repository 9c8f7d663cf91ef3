// Bricks to octrees and their files and back: every finest voxel's log-odds, to the bit.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTreeStamped.h>

#include <filesystem>
#include <sstream>

#include "../oracle/BeamOracle.h"
#include "../support/KnownVoxels.h"
#include "../support/TempDir.h"
#include "RandomBeams.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using mrpt_mapconv::testing::readBytes;
using mrpt_mapconv::testing::TempDir;
using voxel::VoxelGrid;
using voxel::VoxelKey;

/** A key around another one that an octree has. */
std::int32_t keyNear(Rng& rng, std::int32_t key, std::int32_t side = 1)
{
  return std::max(-32768, std::min(32768 - side, (key + pick(rng, -40, 40)) & -side));
}

VoxelKey keyNear(Rng& rng, const VoxelKey& key, std::int32_t side = 1)
{
  return {keyNear(rng, key.x, side), keyNear(rng, key.y, side), keyNear(rng, key.z, side)};
}

void insertSomeRays(Rng& rng, const VoxelKey& around, VoxelGrid& grid)
{
  std::vector<voxel::Ray> rays;
  const auto pointNear = [&](const VoxelKey& key)
  {
    const auto at = [&](std::int32_t k) { return (k + 0.5) * grid.resolution(); };
    return mrpt::math::TPoint3D(at(key.x), at(key.y), at(key.z));
  };
  for (int i = 0; i < 50; ++i)
    rays.push_back({pointNear(keyNear(rng, around)), pointNear(keyNear(rng, around)),
                    static_cast<voxel::RayEnd>(pick(rng, 0, 2))});
  voxel::insertRays(grid, rays);
}

/** By all ways in which voxels come into a grid. */
VoxelGrid randomGrid(Rng& rng, RandomBeams& beams)
{
  VoxelGrid grid(beams.resolution());
  for (int step = pick(rng, 0, 6); step > 0; --step) switch (pick(rng, 0, 3))
    {
      case 0:
        voxel::insertScan(grid, beams.scan(100), finiteInsertion(rng, beams.resolution()));
        break;
      case 1:
        insertSomeRays(rng, beams.home(), grid);
        break;
      case 2:
        for (int i = 0; i < 200; ++i)
          grid.set(keyNear(rng, beams.home()),
                   chance(rng, 10) ? voxel::kUntouched : static_cast<float>(uniform(rng, -12, 12)));
        break;
      default:
      {
        const int side = 1 << pick(rng, 0, 6);
        grid.fillCube(keyNear(rng, beams.home(), side), side,
                      chance(rng, 20) ? voxel::kUntouched
                                      : 0.25f * static_cast<float>(pick(rng, -4, 4)) + 0.0f);
      }
    }
  return grid;
}

/** What OctoMap itself makes of the nodes of a file. */
octomap::OcTree readByOctomap(const std::string& bytes, double resolution)
{
  octomap::OcTree tree(resolution);
  const std::string last = "\ndata\n";
  std::istringstream nodes(bytes.substr(bytes.find(last) + last.size()));
  if (nodes.rdbuf()->in_avail() > 0) tree.readData(nodes);
  return tree;
}

/** The nodes as OctoMap writes them. */
std::string nodesOf(const octomap::OcTree& tree)
{
  std::ostringstream out;
  if (tree.size() > 0) tree.writeData(out);
  return out.str();
}

template <class Tree>
class OctreeRoundTrip : public ::testing::Test
{
};
using Trees = ::testing::Types<octomap::OcTree, octomap::ColorOcTree, octomap::OcTreeStamped>;
TYPED_TEST_SUITE(OctreeRoundTrip, Trees);

TYPED_TEST(OctreeRoundTrip, ATreesVoxelsComeBack)
{
  for (unsigned seed = 1; seed <= 60 && !this->HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    TypeParam tree(0.1);
    randomTree(rng, randomShape(rng), tree);
    const auto voxels = knownVoxels(tree);
    const VoxelGrid grid = voxel::toVoxelGrid(tree);
    EXPECT_TRUE(sameVoxels(knownVoxels(grid), voxels));
    EXPECT_EQ(grid.occupiedFrom(), tree.getOccupancyThresLog());
    for (const bool pruned : {true, false})
    {
      const auto back = voxel::toOcTree(grid, pruned);
      EXPECT_TRUE(sameVoxels(knownVoxels(*back), voxels));
      EXPECT_FLOAT_EQ(back->getOccupancyThresLog(), tree.getOccupancyThresLog());
      EXPECT_EQ(back->getResolution(), tree.getResolution());
    }
  }
}

TEST(GridRoundTrip, AGridsVoxelsComeBackAndItsTreeIsOctoMapsOwn)
{
  for (unsigned seed = 1; seed <= 120 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    RandomBeams beams(rng);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + beams.text());
    const VoxelGrid grid = randomGrid(rng, beams);
    const auto voxels = knownVoxels(grid);
    ASSERT_EQ(voxels.size(), grid.size());
    ASSERT_EQ(voxels.empty(), grid.empty());

    const auto pruned = voxel::toOcTree(grid), whole = voxel::toOcTree(grid, false);
    EXPECT_TRUE(sameVoxels(knownVoxels(*pruned), voxels));
    EXPECT_EQ(whole->getNumLeafNodes(), voxels.size());
    octomap::OcTree twin(*whole);  // the same, by OctoMap
    twin.updateInnerOccupancy();
    EXPECT_TRUE(nodesOf(*whole) == nodesOf(twin));
    twin.prune();
    EXPECT_TRUE(nodesOf(*pruned) == nodesOf(twin));

    for (const auto* tree : {pruned.get(), whole.get()})
    {
      const auto bytes = voxel::fullOctree(grid, tree == pruned.get());
      EXPECT_TRUE(bytes == voxel::fullOctree(*tree));
      EXPECT_TRUE(sameVoxels(knownVoxels(voxel::toVoxelGrid(*tree)), voxels));
      EXPECT_TRUE(sameVoxels(knownVoxels(voxel::readVoxelGrid(bytes, "memory")), voxels));
      EXPECT_TRUE(sameVoxels(knownVoxels(readByOctomap(bytes, grid.resolution())), voxels));
    }
  }
}

/** The states of voxels, as log-odds of −1 and 1. */
KnownVoxels statesOf(KnownVoxels voxels, float occupiedFrom)
{
  for (auto& voxel : voxels)
  {
    float logOdds = 0;
    std::memcpy(&logOdds, &voxel.bits, sizeof(logOdds));
    voxel.bits = bitsOf(logOdds >= occupiedFrom ? 1.0f : -1.0f);
  }
  return voxels;
}

TEST(GridRoundTrip, BinaryFilesKeepTheStatesAndAreThoseOfTheTree)
{
  const TempDir dir;
  for (unsigned seed = 1; seed <= 60 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    RandomBeams beams(rng);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + beams.text());
    VoxelGrid grid = randomGrid(rng, beams);
    if (chance(rng, 40)) grid.setOccupiedFrom(chance(rng, 50) ? 0.5f : -0.5f);
    const auto states = statesOf(knownVoxels(grid), grid.occupiedFrom());
    for (const bool pruned : {true, false})
    {
      const auto tree = voxel::toOcTree(grid, pruned);
      voxel::writeOctreeFile(dir.path("grid.bt"), grid, pruned, "a remark");
      voxel::writeOctreeFile(dir.path("tree.bt"), *tree, "a remark");
      const auto bytes = readBytes(dir.path("grid.bt"));
      EXPECT_TRUE(bytes == readBytes(dir.path("tree.bt")));
      const auto read = voxel::readOctree(bytes, "memory");
      EXPECT_TRUE(
          sameVoxels(statesOf(knownVoxels(dynamic_cast<octomap::OcTree&>(*read)), 0), states));
    }
  }
}

TEST(GridRoundTrip, BytesAreThoseOfATreeThatOctoMapMade)
{
  for (unsigned seed = 1; seed <= 60 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    RandomBeams beams(rng);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + beams.text());
    const bool pruning = chance(rng, 70);
    VoxelGrid grid(beams.resolution());
    octomap::OcTree tree(beams.resolution());
    for (int i = pick(rng, 0, 4); i > 0; --i)
    {
      auto options = finiteInsertion(rng, beams.resolution());
      options.pruning = pruning;
      const auto scan = beams.scan(200);
      voxel::insertScan(grid, scan, options);
      oracle::insertScan(tree, scan, options);
    }
    EXPECT_TRUE(voxel::fullOctree(grid, pruning) == voxel::fullOctree(tree));
  }
}

TEST(GridRoundTrip, ARealMapsVoxelsComeBack)
{
  const std::filesystem::path file = std::filesystem::path(MRPT_MAPCONV_SHARED_DIR) / "geb079.bt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const auto read = voxel::readOctreeFile(file.string());
  const auto& tree = dynamic_cast<const octomap::OcTree&>(*read);
  const VoxelGrid grid = voxel::toVoxelGrid(tree);
  std::size_t voxels = 0, wrong = 0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf)
  {
    const auto first = leaf.getIndexKey();
    const int side = 1 << (16 - leaf.getDepth());
    for (int i = 0; i < side * side * side; ++i, ++voxels)
      wrong +=
          bitsOf(grid.logOdds({first[0] - 32768 + i % side, first[1] - 32768 + i / side % side,
                               first[2] - 32768 + i / side / side})) != bitsOf(leaf->getLogOdds());
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(voxels, grid.size());
  EXPECT_GT(voxels, 428144u);

  const TempDir dir;
  octomap::OcTree pruned(tree);
  pruned.updateInnerOccupancy();
  pruned.prune();
  EXPECT_TRUE(voxel::fullOctree(grid) == voxel::fullOctree(pruned));
  voxel::writeOctreeFile(dir.path("grid.bt"), grid);
  voxel::writeOctreeFile(dir.path("tree.bt"), pruned);
  EXPECT_TRUE(readBytes(dir.path("grid.bt")) == readBytes(dir.path("tree.bt")));
  const auto again = voxel::readVoxelGrid(voxel::fullOctree(grid, false), "memory");
  EXPECT_TRUE(voxel::fullOctree(grid) == voxel::fullOctree(again));
}

}  // namespace
