// Parts of a walk are what the whole walk has there, and are exact however long the ray.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/RayWalk.h>

#include <algorithm>
#include <string>
#include <vector>

#include "RandomRays.h"
#include "SeenVoxels.h"
#include "oracle/RayOracle.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using voxel::GridRay;
using voxel::Slab;

constexpr std::uint32_t kSeeds = 100;
constexpr int kRaysOfSeed = 200;

/** Any partition along an axis. */
std::vector<Slab> randomPartition(RandomRays& random, int axis, std::int64_t around)
{
  std::vector<Slab> slabs{{axis, INT64_MIN, INT64_MAX}};
  std::int64_t border = (around >> voxel::kBrickBits) * voxel::kBrickSide - 4 * voxel::kBrickSide;
  while (slabs.size() < 8)
  {
    border += random.between(1, 2) * voxel::kBrickSide;
    slabs.back().end = border;
    slabs.push_back({axis, border, INT64_MAX});
  }
  return slabs;
}

/** Slabs in the order in which a ray comes to them. */
std::vector<Slab> alongRay(std::vector<Slab> slabs, const GridRay& ray)
{
  const auto axis = static_cast<std::size_t>(slabs.front().axis);
  if (ray.to[axis] < ray.from[axis]) std::reverse(slabs.begin(), slabs.end());
  return slabs;
}

TEST(RayWalkSlabs, TheSlabsOfAPartitionHaveTheVoxelsOfTheWholeWalk)
{
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
  {
    const std::int64_t center = seed % 2 ? 0 : -32768;
    RandomRays random(seed, center - 70, center + 70);
    for (int i = 0; i < kRaysOfSeed; ++i)
    {
      const GridRay ray = random.any();
      const auto axis = static_cast<int>(random.between(0, 2));
      SeenVoxels parts, wideParts;
      for (const Slab& slab : alongRay(randomPartition(random, axis, center), ray))
      {
        const std::size_t before = parts.voxels.size();
        voxel::walkRayAs<std::int64_t>(ray, slab, parts);
        voxel::walkRayAs<Wide>(ray, slab, wideParts);
        for (std::size_t v = before; v < parts.voxels.size(); ++v)
        {
          EXPECT_GE(keyOn(axis, parts.voxels[v]), slab.begin);
          EXPECT_LT(keyOn(axis, parts.voxels[v]), slab.end);
        }
      }
      const SeenVoxels whole = seenAs<std::int64_t>(ray);
      ASSERT_EQ(text(whole.voxels), text(parts.voxels)) << "seed " << seed << text(ray);
      ASSERT_EQ(text(whole.voxels), text(wideParts.voxels)) << "seed " << seed << text(ray);
      ASSERT_EQ(1, parts.ends) << "seed " << seed << text(ray);
    }
  }
}

/** The voxels around a part of a ray, with one more on each side. */
oracle::KeyBox boxAround(const GridRay& ray, std::size_t axis, std::int64_t begin, std::int64_t end)
{
  oracle::KeyBox box = oracle::boxOf(ray);
  const auto keyAt = [&](std::size_t i, std::int64_t face)
  {
    const auto along = static_cast<Wide>(ray.to[axis] - ray.from[axis]);
    const Wide passed = face * voxel::kRayUnits - ray.from[axis];
    const Wide there = ray.from[i] + passed * (ray.to[i] - ray.from[i]) / along;
    return static_cast<std::int64_t>(there) >> voxel::kRayBits;
  };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto [first, last] = std::minmax({keyAt(i, begin), keyAt(i, end)});
    box.low[i] = std::max(box.low[i], i == axis ? begin : first - 1);
    box.high[i] = std::min(box.high[i], i == axis ? end - 1 : last + 1);
  }
  return box;
}

Wide volumeOf(const oracle::KeyBox& box)
{
  Wide volume = 1;
  for (std::size_t i = 0; i < 3; ++i) volume *= box.high[i] - box.low[i] + 1;
  return volume;
}

TEST(RayWalkSlabs, IsExactWhereverOnARayAcrossTheWholeRangeOfKeys)
{
  constexpr std::int64_t most = std::int64_t{1} << 31;
  int slabs = 0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
  {
    RandomRays random(seed, -most, most);
    for (int i = 0; i < 40; ++i)
    {
      const GridRay ray = i % 2 ? random.anywhere() : random.diagonal();
      const auto axis = static_cast<std::size_t>(random.between(0, 2));
      const auto reach = oracle::boxOf(ray);
      if (voxel::isShort(ray) || reach.high[axis] - reach.low[axis] < 1000) continue;
      const std::int64_t begin = random.between((reach.low[axis] >> voxel::kBrickBits) + 1,
                                                (reach.high[axis] >> voxel::kBrickBits) - 1) *
                                 voxel::kBrickSide;
      const std::int64_t end = begin + voxel::kBrickSide;
      const auto box = boxAround(ray, axis, begin, end);
      if (volumeOf(box) > 100'000) continue;
      ++slabs;
      const SeenVoxels seen = seenAs<Wide>(ray, {static_cast<int>(axis), begin, end});
      ASSERT_EQ(text(voxelsOnRay(ray, box)), text(seen.voxels)) << "seed " << seed << text(ray);
    }
  }
  EXPECT_GT(slabs, 2000);
}

TEST(RayWalkSlabs, IsExactAlongTheWholeOfALongThinRay)
{
  RandomRays random(11, -3, 3);
  for (int i = 0; i < 12; ++i)
  {
    GridRay ray = i % 2 ? random.anywhere() : random.betweenCorners();
    const auto axis = static_cast<std::size_t>(i / 4);
    ray.to[axis] += (i / 2 % 2 ? 1 : -1) * random.between(4200, 5000) * voxel::kRayUnits;
    ASSERT_FALSE(voxel::isShort(ray));
    const auto expected = voxelsOnRay(ray, oracle::boxOf(ray));
    EXPECT_TRUE(expected == voxel::voxelsOnRay(ray)) << text(ray);
  }
}
}  // namespace
