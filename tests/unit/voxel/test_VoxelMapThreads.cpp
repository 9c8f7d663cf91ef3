// What several threads may do to a voxel map at once. Worth running with ThreadSanitizer, see
// CONTRIBUTING.md.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <mrpt_mapconv/voxel/VoxelMap.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace mrpt_mapconv;
using voxel::VoxelMap;

/** Calls work(i) in a thread of its own for each i. */
template <class Work>
void atOnce(std::size_t count, const Work& work)
{
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < count; ++i) threads.emplace_back([&work, i] { work(i); });
  for (auto& thread : threads) thread.join();
}

/** A sensor within a sphere of points. */
observation::SensorPoints sphere(double x)
{
  observation::SensorPoints scan;
  scan.sensorPose = mrpt::poses::CPose3D(x, 0, 0, 0, 0, 0);
  for (int azimuth = 0; azimuth < 120; ++azimuth)
    for (int elevation = -20; elevation <= 20; ++elevation)
    {
      const double a = azimuth * M_PI / 60, e = elevation * M_PI / 50;
      scan.points.emplace_back(static_cast<float>(5 * std::cos(a) * std::cos(e)),
                               static_cast<float>(5 * std::sin(a) * std::cos(e)),
                               static_cast<float>(5 * std::sin(e)));
    }
  return scan;
}

TEST(VoxelMapThreads, GetTheSameOctree)
{
  VoxelMap map(0.2);
  for (int scan = 0; scan < 3; ++scan)
  {
    map.insertScan(sphere(scan), {}, nullptr, {}, 3);
    std::vector<const octomap::OcTree*> trees(4);
    std::vector<std::string> bytes(4);
    atOnce(4,
           [&](std::size_t i)
           {
             EXPECT_FALSE(map.empty());
             if (i % 2) bytes[i] = map.fullOctree();
             trees[i] = &map.octree();
             EXPECT_TRUE(map.hasFree());
             if (i % 2 == 0) bytes[i] = VoxelMap(map).fullOctree();
           });
    EXPECT_EQ(1u, std::set(trees.begin(), trees.end()).size());
    EXPECT_EQ(1u, std::set(bytes.begin(), bytes.end()).size());
  }
}

TEST(VoxelMapThreads, InsertIntoGridsOfTheirOwn)
{
  std::vector<voxel::Ray> rays;
  for (const auto& p : sphere(0).points) rays.push_back({{0, 0, 0}, {p.x, p.y, p.z}});
  std::vector<std::size_t> sizes(3);
  atOnce(3,
         [&](std::size_t i)
         {
           voxel::VoxelGrid grid(0.1);
           for (int round = 0; round < 3; ++round)
             insertRays(grid, rays, {}, static_cast<int>(i) + 2);
           sizes[i] = grid.size();
         });
  EXPECT_EQ(1u, std::set(sizes.begin(), sizes.end()).size());
}
}  // namespace
