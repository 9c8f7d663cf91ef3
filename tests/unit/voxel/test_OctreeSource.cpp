// Reading OctoMap's trees block by block, against asking them voxel by voxel.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/ColorOcTree.h>
#include <octomap/CountingOcTree.h>
#include <octomap/OcTreeStamped.h>
#include <octomap/octomap.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <string>

#include "../../oracle/DenseMap.h"
#include "BlockColumns.h"

namespace
{
using namespace mrpt_mapconv;
using oracle::octomapKey;
using oracle::Voxel;
using test::everyColumn;
using test::stateIn;
using voxel::ColumnBlock;
using voxel::ColumnMask;
using voxel::kBlockSide;

/** Every voxel of the block's wanted columns, in the block's range of heights and a bit beyond. */
template <class Tree>
void expectBlockEqualsSearch(const Tree& tree, const ColumnBlock& block, int zBegin, int zEnd)
{
  int wrong = 0;
  for (int y = 0; y < kBlockSide; ++y)
    for (int x = 0; x < kBlockSide; ++x)
    {
      if (!(block.wanted()[static_cast<std::size_t>(y)] >> x & 1u)) continue;
      const int kx = block.key().x * kBlockSide + x, ky = block.key().y * kBlockSide + y;
      for (int kz = zBegin; kz < zEnd && wrong < 5; ++kz)
      {
        const Voxel expected = oracle::askTree(tree, kx, ky, kz);
        const Voxel state = stateIn(block, x, y, kz);
        if (state == expected) continue;
        ++wrong;
        ADD_FAILURE() << "voxel (" << kx << ", " << ky << ", " << kz << ") is "
                      << static_cast<int>(state) << ", expected " << static_cast<int>(expected);
      }
    }
}

int blockOf(int key) { return (key + 65536) / kBlockSide - 65536 / kBlockSide; }

/** bounds() against OctoMap's leaf iterator and every block against search(). */
template <class Tree>
void expectSourceEqualsTree(const Tree& tree, const ColumnMask& wanted)
{
  const voxel::OctreeSource<Tree> source(tree);
  EXPECT_EQ(source.resolution(), tree.getResolution());
  const oracle::DenseMap box = oracle::boundsOf(tree);
  const auto bounds = source.bounds();
  ASSERT_TRUE(bounds);
  EXPECT_EQ(bounds->xMin, box.x0);
  EXPECT_EQ(bounds->yMin, box.y0);
  EXPECT_EQ(bounds->xMax, box.x0 + box.nx - 1);
  EXPECT_EQ(bounds->yMax, box.y0 + box.ny - 1);
  const int zBegin = std::max(-32768, box.z0 - 70), zEnd = std::min(32768, box.z0 + box.nz + 70);
  ColumnBlock block;  // the same one again and again, as the conversion does
  for (int by = blockOf(box.y0) - 1; by <= blockOf(box.y0 + box.ny - 1) + 1; ++by)
    for (int bx = blockOf(box.x0) - 1; bx <= blockOf(box.x0 + box.nx - 1) + 1; ++bx)
    {
      if (bx < -1024 || by < -1024 || bx >= 1024 || by >= 1024) continue;
      SCOPED_TRACE("block (" + std::to_string(bx) + ", " + std::to_string(by) + ")");
      block.start({bx, by}, wanted);
      source.read(block);
      EXPECT_EQ(block.zMin() % 32, 0);
      expectBlockEqualsSearch(tree, block, zBegin, zEnd);
    }
}

template <class Tree>
class OctreeSource : public ::testing::Test
{
 protected:
  Tree m_tree{0.1};

  void fill(int kx, int ky, int kz, int side, float logOdds)
  {
    for (int x = kx; x < kx + side; ++x)
      for (int y = ky; y < ky + side; ++y)
        for (int z = kz; z < kz + side; ++z)
          m_tree.setNodeValue(octomapKey(x, y, z), logOdds, true);
  }

  /** Adds one leaf at the given depth, where no finer node may be yet. */
  void addLeaf(int kx, int ky, int kz, unsigned depth, float logOdds)
  {
    const octomap::OcTreeKey key = octomapKey(kx, ky, kz);
    auto* node = m_tree.getRoot();
    for (unsigned d = 0; d < depth; ++d)
    {
      const unsigned child = octomap::computeChildIdx(key, static_cast<int>(15 - d));
      node = m_tree.nodeChildExists(node, child) ? m_tree.getNodeChild(node, child)
                                                 : m_tree.createNodeChild(node, child);
    }
    node->setLogOdds(logOdds);
  }
};
using Trees = ::testing::Types<octomap::OcTree, octomap::ColorOcTree, octomap::OcTreeStamped>;
TYPED_TEST_SUITE(OctreeSource, Trees);

TYPED_TEST(OctreeSource, EmptyTreeHasNoBoundsAndNoVoxels)
{
  const voxel::OctreeSource<TypeParam> source(this->m_tree);
  EXPECT_FALSE(source.bounds());
  ColumnBlock block;
  block.start({0, 0}, everyColumn());
  source.read(block);
  for (int kz = -100; kz < 100; ++kz) EXPECT_EQ(stateIn(block, 3, 4, kz), Voxel::Unknown);
}

TYPED_TEST(OctreeSource, OneVoxel)
{
  for (const int key : {0, -1, 31, 32, -32, -33, 32767, -32768})
  {
    SCOPED_TRACE("key " + std::to_string(key));
    this->m_tree.clear();
    this->m_tree.setNodeValue(octomapKey(key, key, key), -0.4f);
    expectSourceEqualsTree(this->m_tree, everyColumn());
  }
}

TYPED_TEST(OctreeSource, AllSizesOfPrunedLeaves)
{
  // cubes of 1 … 32 voxels, free and occupied, on both sides of the origin
  for (int side = 1; side <= 32; side *= 2)
  {
    this->fill(64 - 3 * side, -2 * side, side, side, -0.4f);
    this->fill(-64 - side, 2 * side, -3 * side, side, 0.85f);
  }
  this->m_tree.prune();
  expectSourceEqualsTree(this->m_tree, everyColumn());
}

TYPED_TEST(OctreeSource, LeavesLargerThanABlock)
{
  this->m_tree.setNodeValue(octomapKey(-70, 40, 3), 0.85f);
  this->addLeaf(0, 0, -64, 10, -0.4f);  // 64 voxels to a side: four blocks
  this->addLeaf(-256, 0, 0, 9, 0.85f);  // 128: sixteen
  this->addLeaf(64, 0, 0, 11, -0.4f);   // 32: exactly one
  expectSourceEqualsTree(this->m_tree, everyColumn());
}

TYPED_TEST(OctreeSource, AHoleInALargeLeaf)
{
  this->m_tree.setNodeValue(octomapKey(200, 40, 3), 0.85f);
  this->addLeaf(0, 0, 0, 10, -0.4f);
  this->m_tree.setNodeValue(octomapKey(33, 20, 10), 0.85f);  // OctoMap splits the leaf around it
  this->m_tree.deleteNode(octomapKey(5, 40, 63));
  ASSERT_EQ(oracle::askTree(this->m_tree, 5, 40, 63), Voxel::Unknown);
  ASSERT_EQ(oracle::askTree(this->m_tree, 33, 20, 10), Voxel::Occupied);
  ASSERT_EQ(oracle::askTree(this->m_tree, 0, 63, 0), Voxel::Free);
  expectSourceEqualsTree(this->m_tree, everyColumn());
}

TYPED_TEST(OctreeSource, AVeryLargeLeafHasItsWholeBounds)
{
  this->m_tree.setNodeValue(octomapKey(-1, -1, -1), 0.85f);
  this->addLeaf(0, 0, 0, 3, -0.4f);  // 8192 voxels to a side
  const voxel::OctreeSource<TypeParam> source(this->m_tree);
  const auto bounds = source.bounds();
  ASSERT_TRUE(bounds);
  EXPECT_EQ(bounds->xMin, -1);
  EXPECT_EQ(bounds->yMin, -1);
  EXPECT_EQ(bounds->xMax, 8191);
  EXPECT_EQ(bounds->yMax, 8191);
  ColumnBlock block;
  block.start({255, 0}, everyColumn());
  source.read(block);
  expectBlockEqualsSearch(this->m_tree, block, -10, 100);
  expectBlockEqualsSearch(this->m_tree, block, 8100, 8300);
}

TYPED_TEST(OctreeSource, RandomVoxelsAndRandomColumns)
{
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 rng(seed);
    const auto pick = [&](int low, int high)
    { return low + static_cast<int>(rng() % static_cast<unsigned>(high - low + 1)); };
    this->m_tree.clear();
    const int x = pick(-80, 80), y = pick(-80, 80), z = pick(-200, 200), height = pick(1, 120);
    for (int i = 0; i < 3000; ++i)
      this->m_tree.setNodeValue(octomapKey(x + pick(0, 40), y + pick(0, 40), z + pick(0, height)),
                                pick(0, 2) == 0 ? 0.0f : -0.01f * static_cast<float>(pick(1, 2)),
                                true);
    if (seed % 2 == 0) this->m_tree.prune();
    ColumnMask wanted{};
    for (std::uint32_t& row : wanted)
      row = static_cast<std::uint32_t>(rng()) & static_cast<std::uint32_t>(rng());
    expectSourceEqualsTree(this->m_tree, seed % 3 == 0 ? everyColumn() : wanted);
  }
}

TYPED_TEST(OctreeSource, ASingleWantedColumn)
{
  this->fill(0, 0, 0, 32, -0.4f);
  this->m_tree.setNodeValue(octomapKey(17, 9, 5), 0.85f);
  this->m_tree.prune();
  for (const int x : {0, 17, 31})
  {
    ColumnMask wanted{};
    wanted[9] = 1u << x;
    expectSourceEqualsTree(this->m_tree, wanted);
  }
}

TYPED_TEST(OctreeSource, InnerNodesAreNoVoxels)
{
  // one finest voxel under inner nodes that are never brought up to date
  this->m_tree.setNodeValue(octomapKey(7, 7, 7), -0.4f, true);
  expectSourceEqualsTree(this->m_tree, everyColumn());
}

TYPED_TEST(OctreeSource, IsMadeForEveryOccupancyTree)
{
  this->m_tree.setNodeValue(octomapKey(3, 4, 5), 0.85f);
  const auto source = voxel::makeOctreeSource(this->m_tree);
  ASSERT_TRUE(source);
  EXPECT_EQ(source->resolution(), 0.1);
  ASSERT_TRUE(source->bounds());
  EXPECT_EQ(source->bounds()->xMin, 3);
  EXPECT_EQ(source->bounds()->yMin, 4);
  ColumnBlock block;
  block.start({0, 0}, everyColumn());
  source->read(block);
  EXPECT_EQ(stateIn(block, 3, 4, 5), Voxel::Occupied);
  EXPECT_EQ(stateIn(block, 4, 4, 5), Voxel::Unknown);
}

TEST(MakeOctreeSource, ATreeWithoutOccupancyIsAnError)
{
  octomap::CountingOcTree tree(0.1);
  tree.updateNode(octomap::point3d(0, 0, 0));
  try
  {
    voxel::makeOctreeSource(tree);
    FAIL() << "a tree of counters was accepted";
  }
  catch (const std::invalid_argument& e)
  {
    // CountingOcTree calls itself by its base class's name
    EXPECT_NE(std::string(e.what()).find("OcTreeBase"), std::string::npos) << e.what();
  }
}

}  // namespace
