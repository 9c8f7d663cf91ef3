#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/OcTree.h>

#include <cmath>

#include "support/ScanFixtures.h"

using namespace mrpt_mapconv;
using observation::SensorPoints;
using voxel::insertScan;
using voxel::TVoxelInsertionOptions;

namespace
{
SensorPoints scan(std::vector<mrpt::math::TPoint3Df> points, mrpt::poses::CPose3D pose = {})
{
  return {pose, std::move(points)};
}

enum class State
{
  Unknown,
  Free,
  Occupied
};
State stateAt(const octomap::OcTree& tree, double x, double y, double z)
{
  const auto* node = tree.search(x, y, z);
  if (!node) return State::Unknown;
  return tree.isNodeOccupied(node) ? State::Occupied : State::Free;
}
}  // namespace

TEST(VoxelInsertion, ABeamIsFreeAlongItsWayAndOccupiedAtItsEnd)
{
  octomap::OcTree tree(1.0);
  const auto changed = insertScan(tree, scan({{4, 0, 0}}, {0.5, 0.5, 0.5, 0, 0, 0}), {});
  for (int x = 0; x < 4; ++x) EXPECT_EQ(stateAt(tree, x + 0.5, 0.5, 0.5), State::Free) << x;
  EXPECT_EQ(stateAt(tree, 4.5, 0.5, 0.5), State::Occupied);
  EXPECT_EQ(stateAt(tree, 5.5, 0.5, 0.5), State::Unknown);
  EXPECT_EQ(changed.size(), 5u);
  for (int x = 0; x < 5; ++x) EXPECT_TRUE(changed.contains(x, 0)) << x;
}

TEST(VoxelInsertion, PointsAreInTheSensorsFrame)
{
  octomap::OcTree tree(1.0);
  // the sensor looks along +y: its x axis is the map's y axis
  insertScan(tree, scan({{3, 0, 0}}, {0.5, 0.5, 0.5, mrpt::DEG2RAD(90.0), 0, 0}), {});
  EXPECT_EQ(stateAt(tree, 0.5, 3.5, 0.5), State::Occupied);
  EXPECT_EQ(stateAt(tree, 3.5, 0.5, 0.5), State::Unknown);
}

TEST(VoxelInsertion, NothingIsReportedWhereNothingChanges)
{
  octomap::OcTree tree(1.0);
  const auto once = scan({{4, 0, 0}}, {0.5, 0.5, 0.5, 0, 0, 0});
  insertScan(tree, once, {});
  EXPECT_TRUE(insertScan(tree, once, {}).empty());  // surer, but no voxel changed its state
}

TEST(VoxelInsertion, MaxRangeLeavesTheEndOut)
{
  octomap::OcTree tree(1.0);
  TVoxelInsertionOptions options;
  options.maxrange = 2.5;
  insertScan(tree, scan({{4, 0, 0}}, {0.5, 0.5, 0.5, 0, 0, 0}), options);
  EXPECT_EQ(stateAt(tree, 1.5, 0.5, 0.5), State::Free);
  EXPECT_EQ(stateAt(tree, 4.5, 0.5, 0.5), State::Unknown);
}

TEST(VoxelInsertion, ABeamAsLongAsMaxRangeIsWhole)
{
  TVoxelInsertionOptions options;
  options.maxrange = 4;
  const auto seen = scan({{4, 0, 0}}, {0.5, 0.5, 0.5, 0, 0, 0});
  octomap::OcTree tree(1.0);
  insertScan(tree, seen, options);
  EXPECT_EQ(stateAt(tree, 4.5, 0.5, 0.5), State::Occupied);
  voxel::VoxelGrid grid(1.0);
  insertScan(grid, seen, options);
  EXPECT_GT(grid.logOdds({4, 0, 0}), 0);
}

TEST(VoxelInsertion, ABeamWithoutReturnFreesAndOccupiesNothing)
{
  octomap::OcTree tree(1.0);
  auto seen = scan({}, {0.5, 0.5, 0.5, 0, 0, 0});
  seen.noReturns = {{4, 0, 0}};
  const auto changed = insertScan(tree, seen, {});
  EXPECT_EQ(stateAt(tree, 3.5, 0.5, 0.5), State::Free);
  EXPECT_EQ(stateAt(tree, 4.5, 0.5, 0.5), State::Unknown);
  EXPECT_EQ(4u, changed.size());

  voxel::VoxelMap map(1.0);
  grid::GridFrame frame;
  map.insertScan(seen, {}, nullptr, [&frame](const grid::GridFrame& f) { frame = f; });
  EXPECT_EQ((grid::GridFrame{1.0, 0, 0, 5, 1}), frame);

  TVoxelInsertionOptions options;
  options.maxrange = 2.5;
  octomap::OcTree shorter(1.0);
  insertScan(shorter, seen, options);
  EXPECT_EQ(stateAt(shorter, 1.5, 0.5, 0.5), State::Free);
  EXPECT_EQ(stateAt(shorter, 3.5, 0.5, 0.5), State::Unknown);
}

TEST(VoxelInsertion, AReturnWinsOverABeamWithoutOne)
{
  octomap::OcTree tree(1.0);
  auto seen = scan({{2, 0, 0}}, {0.5, 0.5, 0.5, 0, 0, 0});
  seen.noReturns = {{4, 0, 0}};
  insertScan(tree, seen, {});
  EXPECT_EQ(stateAt(tree, 2.5, 0.5, 0.5), State::Occupied);
  EXPECT_EQ(stateAt(tree, 3.5, 0.5, 0.5), State::Free);
}

TEST(VoxelInsertion, PruningMergesEqualVoxelsAndWithoutItNothingIsMerged)
{
  for (const bool pruning : {true, false})
  {
    octomap::OcTree tree(1.0);
    TVoxelInsertionOptions options;
    options.pruning = pruning;
    std::vector<mrpt::math::TPoint3Df> points;  // a 2×2×2 cube, each voxel hit once
    for (int i = 0; i < 8; ++i)
      points.emplace_back(10.5f + static_cast<float>(i & 1), 0.5f + static_cast<float>(i >> 1 & 1),
                          0.5f + static_cast<float>(i >> 2));
    // probMiss 0.5 leaves what the beams cross as it is
    options.probMiss = 0.5;
    options.occupancyThres = 0.6;
    insertScan(tree, scan(points, {-5.5, 0.6, 0.6, 0, 0, 0}), options);
    const std::size_t leaves = tree.getNumLeafNodes();
    tree.prune();
    EXPECT_EQ(tree.getNumLeafNodes() < leaves, !pruning);
  }
}

TEST(VoxelInsertion, AnotherThresholdMakesEveryColumnAChangedOne)
{
  octomap::OcTree tree(1.0);
  insertScan(tree, scan({{4, 0, 0}}, {0.5, 0.5, 0.5, 0, 0, 0}), {});
  TVoxelInsertionOptions options;
  options.occupancyThres = 0.9;
  const auto changed = insertScan(tree, scan({{0, 3, 0}}, {0.5, 0.5, 0.5, 0, 0, 0}), options);
  EXPECT_TRUE(changed.contains(4, 0));
  EXPECT_EQ(stateAt(tree, 4.5, 0.5, 0.5), State::Free);  // hit once: 0.7 < 0.9
}

TEST(VoxelInsertion, BeamsThatLeaveTheTreeAreLeftOutWithOneWarning)
{
  octomap::OcTree tree(0.01);  // reaches 327.68 m
  fixtures::Warnings log;
  observation::SayOnceLog warnings(&log);
  insertScan(tree, scan({{1, 0, 0}, {400, 0, 0}, {0, -500, 0}}), {}, &warnings);
  EXPECT_EQ(stateAt(tree, 1.005, 0.005, 0.005), State::Occupied);
  ASSERT_EQ(log.texts.size(), 1u);
  EXPECT_EQ(log.texts[0].rfind("2 points left out", 0), 0u) << log.texts[0];
}

/** In floats the length of such a beam is 0, and OctoMap's walk along it would never end. */
TEST(VoxelInsertion, APointBeyondAnEdgeThatIsTooNearToTellIsAtTheSensor)
{
  const auto seen = scan({{-1e-25f, -1e-25f, 0}}, {0, 0, 0.5, 0, 0, 0});
  octomap::OcTree tree(1.0);
  insertScan(tree, seen, {});
  EXPECT_EQ(stateAt(tree, 0.5, 0.5, 0.5), State::Occupied);
  EXPECT_EQ(tree.getNumLeafNodes(), 1u);
  voxel::VoxelGrid grid(1.0);
  insertScan(grid, seen, {});
  EXPECT_GT(grid.logOdds({0, 0, 0}), 0);
  EXPECT_EQ(grid.size(), 1u);
}

TEST(VoxelInsertion, ABeamThatIsTooLongForOctoMapIsAnErrorAndTheTreeStaysAsItWas)
{
  const auto seen = scan({{1, 0, 0}, {400, 401, 402}}, {-300.005, -300.005, -300.005, 0, 0, 0});
  octomap::OcTree tree(0.01);
  try
  {
    insertScan(tree, seen, {});
    FAIL() << "inserted";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()).rfind("a beam goes through ", 0), 0u) << error.what();
  }
  EXPECT_EQ(tree.size(), 0u);
  voxel::VoxelGrid grid(0.01);
  insertScan(grid, seen, {});
  EXPECT_GT(grid.logOdds({9999, 10099, 10199}), 0);
}

TEST(VoxelInsertion, ABrickWhoseVoxelsStayEqualIsKeptAsOneValue)
{
  voxel::VoxelGrid grid(1.0);
  grid.fillCube({0, 0, 0}, 16, 5);  // above what any hit makes of a voxel
  const auto bytes = grid.heapBytes();
  insertScan(grid, scan({{4, 0, 0}}, {4.5, 4.5, 4.5, 0, 0, 0}), {});
  EXPECT_GT(grid.heapBytes(), bytes);  // misses have changed voxels
  grid.fillCube({0, 0, 0}, 16, 5);
  insertScan(grid, scan({{0.1f, 0, 0}}, {4.5, 4.5, 4.5, 0, 0, 0}), {});
  EXPECT_EQ(grid.heapBytes(), bytes);
}

TEST(VoxelInsertion, ABadSensorPoseIsAnErrorAndTheTreeStaysAsItWas)
{
  octomap::OcTree tree(0.01);
  for (const double x : {std::nan(""), HUGE_VAL, 400.0})
  {
    EXPECT_THROW(insertScan(tree, scan({{1, 0, 0}}, {x, 0, 0, 0, 0, 0}), {}), std::runtime_error);
    EXPECT_EQ(tree.size(), 0u);
  }
}
