#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/OcTree.h>

#include <random>
#include <sstream>

// insertScan() against OctoMap's own insertPointCloud(): the same voxels, bit by bit, in an octree and
// in a grid.

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

void insertAsOctomapDoes(octomap::OcTree& tree, const SensorPoints& scan,
                         const TVoxelInsertionOptions& options)
{
  octomap::Pointcloud cloud;
  for (const auto& point : scan.points)
  {
    double x = 0, y = 0, z = 0;
    scan.sensorPose.composePoint(point.x, point.y, point.z, x, y, z);
    cloud.push_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  }
  const octomap::point3d origin(static_cast<float>(scan.sensorPose.x()),
                                static_cast<float>(scan.sensorPose.y()),
                                static_cast<float>(scan.sensorPose.z()));
  options.applyTo(tree);
  tree.insertPointCloud(cloud, origin, options.maxrange, !options.pruning);
  if (!options.pruning) tree.updateInnerOccupancy();
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
      insertAsOctomapDoes(twin, scan, options);
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

    const auto inMap = [&scan](const mrpt::math::TPoint3Df& point)
    {
      double x = 0, y = 0, z = 0;
      scan.sensorPose.composePoint(point.x, point.y, point.z, x, y, z);
      return octomap::point3d(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    };
    octomap::KeySet hits, crossed;
    octomap::KeyRay ray;
    for (const auto& point : scan.points) hits.insert(twin.coordToKey(inMap(point)));
    for (const auto* ends : {&scan.points, &scan.noReturns})
      for (const auto& end : *ends)
      {
        ASSERT_TRUE(twin.computeRayKeys(inMap({0, 0, 0}), inMap(end), ray));
        crossed.insert(ray.begin(), ray.end());
      }
    for (const auto& key : crossed)
      if (hits.count(key) == 0) twin.updateNode(key, false);
    for (const auto& key : hits) twin.updateNode(key, true);
    EXPECT_TRUE(bytesOf(tree) == bytesOf(twin)) << "seed " << seed;
    EXPECT_TRUE(fullOctree(grid) == fullOctree(twin)) << "seed " << seed;
  }
}
