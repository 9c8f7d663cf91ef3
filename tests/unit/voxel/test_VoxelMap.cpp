// A map of scans that is bricks or an octree, as it is needed.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/VoxelMap.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <thread>

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
using observation::SensorPoints;
using oracle::octomapKey;
using test::sameVoxels;
using voxel::TVoxelInsertionOptions;
using voxel::VoxelEngine;
using voxel::VoxelMap;

/** Beams in all directions, so that there is something to prune. */
SensorPoints scanAt(double x)
{
  SensorPoints scan;
  scan.sensorPose = {x, 0.5, 0.5, 0, 0, 0};
  for (int i = -5; i <= 5; ++i)
    for (int k = -5; k <= 5; ++k)
      for (const float depth : {-6.0f, 6.0f})
      {
        const auto a = static_cast<float>(i), b = static_cast<float>(k);
        scan.points.insert(scan.points.end(), {{depth, a, b}, {a, depth, b}, {a, b, depth}});
      }
  return scan;
}

TVoxelInsertionOptions optionsOf(VoxelEngine engine)
{
  TVoxelInsertionOptions options;
  options.voxelEngine = engine;
  return options;
}

std::unique_ptr<octomap::OcTree> unprunedTree()
{
  auto tree = std::make_unique<octomap::OcTree>(1.0);
  for (int i = 0; i < 8; ++i)
    tree->setNodeValue(octomapKey(i & 1, i >> 1 & 1, i >> 2), -0.25f, true);
  tree->updateInnerOccupancy();
  return tree;
}

/** Maps in every form: bricks, bricks of which an octree was made, and an octree, not pruned. */
void forEachForm(const std::function<void(VoxelMap&)>& test)
{
  for (const std::string form : {"bricks", "bricks and octree", "octree"})
  {
    SCOPED_TRACE(form);
    VoxelMap map(1.0);
    if (form == "octree")
      map.setOctree(unprunedTree());
    else
      map.insertScan(scanAt(0), {});
    if (form == "bricks and octree") map.octree();
    test(map);
  }
}

TEST(VoxelMap, ANewOneIsEmpty)
{
  const VoxelMap map(0.2);
  EXPECT_TRUE(map.empty());
  EXPECT_FALSE(map.hasFree());
  EXPECT_EQ(map.resolution(), 0.2);
  EXPECT_EQ(map.octree().size(), 0u);
  EXPECT_EQ(map.octree().getResolution(), 0.2);
  EXPECT_FALSE(map.source()->bounds());
  for (const double resolution : {0.0, -1.0, 1001.0, std::nan("")})
    EXPECT_THROW(VoxelMap{resolution}, std::invalid_argument) << resolution;
}

TEST(VoxelMap, ItsOctreeIsMadeOnceAndAnewAfterAChange)
{
  for (const auto engine : {VoxelEngine::Blocks, VoxelEngine::Octomap})
  {
    VoxelMap map(1.0);
    map.insertScan(scanAt(0), optionsOf(engine));
    const auto* tree = &map.octree();
    EXPECT_EQ(tree, &map.octree());
    const auto before = test::knownVoxels(*tree);
    VoxelMap copy(map);
    EXPECT_EQ(tree, &map.octree());

    map.insertScan(scanAt(3), optionsOf(engine));
    EXPECT_FALSE(test::knownVoxels(map.octree()) == before);
    EXPECT_TRUE(sameVoxels(test::knownVoxels(copy.octree()), before));
    copy.insertScan(scanAt(3), {});
    EXPECT_TRUE(sameVoxels(map.octree(), copy.octree()));
  }
}

TEST(VoxelMap, SeveralThreadsMayAskForTheOctreeAtOnce)
{
  voxel::VoxelGrid grid(1.0);  // so much that making the octree takes longer than starting a thread
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 64; ++y)
      for (int z = 0; z < 64; ++z) grid.set({x, y, z}, 0.01f * static_cast<float>(x + y + z));
  VoxelMap map(1.0);
  map.setFullOctree(voxel::fullOctree(grid), "memory", 1.0);
  std::array<const octomap::OcTree*, 4> trees{};
  std::vector<std::thread> threads;
  for (auto& tree : trees) threads.emplace_back([&map, &tree] { tree = &map.octree(); });
  for (auto& thread : threads) thread.join();
  for (const auto* tree : trees) EXPECT_EQ(tree, &map.octree());
  EXPECT_EQ(map.octree().getNumLeafNodes(), grid.size());
}

TEST(VoxelMap, ATreeThatWasSetIsTheVeryOneThatComesBack)
{
  auto tree = unprunedTree();
  tree->setProbHit(0.8);
  tree->setOccupancyThres(0.6);
  const auto* address = tree.get();
  VoxelMap map(0.1);
  map.setOctree(std::move(tree));
  EXPECT_EQ(address, &map.octree());
  EXPECT_EQ(map.resolution(), 1.0);
  EXPECT_NEAR(map.model().probHit, 0.8, 1e-6);
  EXPECT_NEAR(map.model().occupancyThres, 0.6, 1e-6);
  EXPECT_EQ(map.octree().getNumLeafNodes(), 8u);
  EXPECT_THROW(map.setOctree(nullptr), std::invalid_argument);
  EXPECT_EQ(address, &map.octree());
}

TEST(VoxelMap, TheSensorModelOfTheLastScanIsTheOctrees)
{
  for (const auto engine : {VoxelEngine::Blocks, VoxelEngine::Octomap})
  {
    auto options = optionsOf(engine);
    options.probHit = 0.8;
    options.probMiss = 0.3;
    options.clampingThresMin = 0.2;
    options.clampingThresMax = 0.9;
    options.occupancyThres = 0.6;
    VoxelMap map(1.0);
    map.insertScan(scanAt(0), options);
    octomap::OcTree model(1.0);
    options.applyTo(model);
    const VoxelMap copy(map);
    for (const auto* tree : {&map.octree(), &copy.octree()})
    {
      EXPECT_EQ(tree->getProbHitLog(), model.getProbHitLog());
      EXPECT_EQ(tree->getProbMissLog(), model.getProbMissLog());
      EXPECT_EQ(tree->getClampingThresMinLog(), model.getClampingThresMinLog());
      EXPECT_EQ(tree->getClampingThresMaxLog(), model.getClampingThresMaxLog());
      EXPECT_EQ(tree->getOccupancyThresLog(), model.getOccupancyThresLog());
    }
  }
}

TEST(VoxelMap, AnotherModelDecidesWhatIsFree)
{
  forEachForm(
      [](VoxelMap& map)
      {
        EXPECT_TRUE(map.hasFree());
        TVoxelInsertionOptions model;
        model.occupancyThres = 0.01;  // below what any number of misses makes of a voxel
        map.setModel(model);
        EXPECT_FALSE(map.hasFree());
        for (auto leaf = map.octree().begin_leafs(); leaf != map.octree().end_leafs(); ++leaf)
          EXPECT_TRUE(map.octree().isNodeOccupied(*leaf));
      });
}

TEST(VoxelMap, AScanThatIsRefusedLeavesItAsItWas)
{
  forEachForm(
      [](VoxelMap& map)
      {
        for (const auto engine : {VoxelEngine::Blocks, VoxelEngine::Octomap})
        {
          const auto bytes = map.fullOctree();
          const VoxelMap copy(map);
          auto options = optionsOf(engine);
          options.probHit = 0.9;
          options.pruning = !options.pruning;
          SensorPoints bad = scanAt(0);
          bad.sensorPose.x(std::nan(""));
          EXPECT_THROW(map.insertScan(bad, options), std::runtime_error);
          EXPECT_THROW(map.insertScan(scanAt(0), options, nullptr,
                                      [](const grid::GridFrame&) { throw std::out_of_range(""); }),
                       std::out_of_range);
          SensorPoints large = scanAt(0);  // too much for a megabyte, or for OctoMap
          large.sensorPose.x(-30000);
          large.points.push_back({62000, 30000, 30000});
          options.maxMemory = 1;
          EXPECT_THROW(map.insertScan(large, options), std::runtime_error);
          EXPECT_TRUE(bytes == map.fullOctree());
          EXPECT_EQ(map.model().probHit, copy.model().probHit);
          EXPECT_TRUE(sameVoxels(map.octree(), copy.octree()));
        }
      });
}

TEST(VoxelMap, ATreeThatNeedsTooMuchMemoryAsBricksStaysATree)
{
  auto tree = unprunedTree();
  for (int i = 0; i < 20; ++i) tree->setNodeValue(octomapKey(1000 * i, 500 * i, 0), 0.5f);
  const auto* address = tree.get();
  VoxelMap map(1.0);
  map.setOctree(std::move(tree));
  TVoxelInsertionOptions options;
  options.maxMemory = 1;
  octomap::OcTree before(map.octree());
  SensorPoints far = scanAt(0);
  for (int i = 0; i < 80; ++i) far.points.push_back({0, 0, 17.0f * static_cast<float>(i + 1)});
  const auto message = messageOf([&] { map.insertScan(far, options); });
  EXPECT_TRUE(contains(message, "maxMemory = 1 MB")) << message;
  EXPECT_EQ(address, &map.octree());
  EXPECT_TRUE(sameVoxels(before, map.octree()));
}

TEST(VoxelMap, ACopyAndAnAssignedMapAreIndependent)
{
  forEachForm(
      [](VoxelMap& map)
      {
        const auto bytes = map.fullOctree();
        VoxelMap copy(map), assigned(0.3);
        assigned = map;
        map.insertScan(scanAt(4), {});
        EXPECT_TRUE(bytes == copy.fullOctree());
        EXPECT_TRUE(bytes == assigned.fullOctree());
        EXPECT_EQ(assigned.resolution(), 1.0);
        const auto& same = copy;
        copy = same;
        EXPECT_TRUE(bytes == copy.fullOctree());
      });
}

TEST(VoxelMap, AMapThatWasMovedAwayIsEmptyAndCanBeUsed)
{
  forEachForm(
      [](VoxelMap& map)
      {
        const auto bytes = map.fullOctree();
        VoxelMap moved(std::move(map));
        EXPECT_TRUE(bytes == moved.fullOctree());
        EXPECT_TRUE(map.empty());  // NOLINT(bugprone-use-after-move)
        map.insertScan(scanAt(0), {});
        map = std::move(moved);
        EXPECT_TRUE(bytes == map.fullOctree());
      });
}

TEST(VoxelMap, ClearForgetsTheVoxelsAndKeepsResolutionAndModel)
{
  forEachForm(
      [](VoxelMap& map)
      {
        TVoxelInsertionOptions model;
        model.occupancyThres = 0.7;
        map.setModel(model);
        map.clear();
        EXPECT_TRUE(map.empty());
        EXPECT_EQ(map.octree().size(), 0u);
        EXPECT_EQ(map.resolution(), 1.0);
        EXPECT_FLOAT_EQ(map.octree().getOccupancyThresLog(), octomap::logodds(0.7));
      });
}

TEST(VoxelMap, AnUnprunedMapStaysUnprunedWhenItIsStoredAndReadAgain)
{
  for (const bool pruning : {false, true})
  {
    TVoxelInsertionOptions options;
    options.pruning = pruning;
    VoxelMap map(1.0), read(1.0);
    map.insertScan(scanAt(0), options);
    EXPECT_EQ(map.octree().getNumLeafNodes() < test::knownVoxels(map.octree()).size(), pruning);
    read.setModel(map.model());
    read.setFullOctree(map.fullOctree(), "stored", 1.0);
    EXPECT_TRUE(map.fullOctree() == read.fullOctree());
  }
}

TEST(VoxelMap, BytesThatCannotBeReadLeaveItAsItWas)
{
  forEachForm(
      [](VoxelMap& map)
      {
        const auto bytes = map.fullOctree();
        EXPECT_THROW(map.setFullOctree(bytes.substr(0, bytes.size() - 1), "cut", 1.0),
                     std::runtime_error);
        EXPECT_EQ(messageOf([&] { map.setFullOctree(bytes, "stored", 2.0); }),
                  "stored: two different resolutions");
        EXPECT_TRUE(bytes == map.fullOctree());
        EXPECT_EQ(map.resolution(), 1.0);
      });
}

TEST(VoxelMap, ItsBtFileIsThatOfItsOctree)
{
  const TempDir dir;
  forEachForm(
      [&dir](VoxelMap& map)
      {
        map.writeOctreeFile(dir.path("map.bt"));
        voxel::writeOctreeFile(dir.path("tree.bt"), map.octree());
        EXPECT_TRUE(readBytes(dir.path("map.bt")) == readBytes(dir.path("tree.bt")));
      });
}

}  // namespace
