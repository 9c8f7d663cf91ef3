#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/OcTree.h>

#include <random>
#include <sstream>

#include "oracle/BeamOracle.h"

// insertScan() against OctoMap's own insertPointCloud(): the same voxels, bit by bit, in an octree
// and in a grid.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::voxel;
using namespace mrpt_mapconv::observation;

namespace
{
constexpr int kScans = 12, kBeams = 400;

/** Scans from places around `middle`, some with beams along the axes or of no length. */
SensorPoints randomScan(std::mt19937& random, const mrpt::poses::CPose3D& middle)
{
  std::uniform_real_distribution<float> any(-1, 1);
  const auto shift = [&] { return 2.0 * static_cast<double>(any(random)); };
  SensorPoints scan;
  scan.sensorPose = middle + mrpt::poses::CPose3D(shift(), shift(), shift());
  for (int i = 0; i < kBeams; ++i)
  {
    const float length = 6 * std::abs(any(random));
    scan.points.emplace_back(length * any(random), length * any(random), length * any(random));
    if (i % 20 == 0) scan.points.emplace_back(length, 0, 0);
    if (i % 50 == 0) scan.points.emplace_back(0.001f, 0, 0);
  }
  return scan;
}

std::string bytesOf(const octomap::OcTree& tree)
{
  std::ostringstream bytes;
  tree.write(bytes);
  return bytes.str();
}

void expectSameTrees(const TVoxelInsertionOptions& options, const mrpt::poses::CPose3D& middle)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    std::mt19937 random(seed);
    octomap::OcTree tree(0.1), twin(0.1);
    VoxelGrid grid(0.1);
    for (int i = 0; i < kScans; ++i)
    {
      const auto scan = randomScan(random, middle);
      insertScan(tree, scan, options);
      insertScan(grid, scan, options);
      oracle::insertScan(twin, scan, options);
    }
    EXPECT_GT(twin.size(), 10000u);
    EXPECT_TRUE(bytesOf(tree) == bytesOf(twin)) << "seed " << seed;
    EXPECT_TRUE(fullOctree(grid, options.pruning) == fullOctree(twin)) << "seed " << seed;
  }
}
}  // namespace

TEST(InsertedVoxels, AreThoseOfOctoMap) { expectSameTrees({}, {}); }

TEST(InsertedVoxels, AreThoseOfOctoMapFarFromTheOrigin)
{
  expectSameTrees({}, mrpt::poses::CPose3D(-3000, 2500, 1200));
}

TEST(InsertedVoxels, AreThoseOfOctoMapWithAMaximumRange)
{
  TVoxelInsertionOptions options;
  options.maxrange = 2.5;
  expectSameTrees(options, {});
}

TEST(InsertedVoxels, AreThoseOfOctoMapWithoutPruning)
{
  TVoxelInsertionOptions options;
  options.pruning = false;
  expectSameTrees(options, {});
}

/** Beams one by one: what none of them hits is free where one goes through. */
TEST(InsertedVoxels, AreThoseOfTheSlowTwinWithBeamsWithoutReturn)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    std::mt19937 random(seed);
    octomap::OcTree tree(0.1), twin(0.1);
    SensorPoints scan = randomScan(random, {});
    scan.noReturns = randomScan(random, {}).points;
    insertScan(tree, scan, {});
    VoxelGrid grid(0.1);
    insertScan(grid, scan, {});

    oracle::insertScan(twin, scan, {});
    EXPECT_TRUE(bytesOf(tree) == bytesOf(twin)) << "seed " << seed;
    EXPECT_TRUE(fullOctree(grid) == fullOctree(twin)) << "seed " << seed;
  }
}
