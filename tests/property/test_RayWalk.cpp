// The walk along a ray comes to the voxels that an exact test of every voxel finds, in that order.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/RayWalk.h>

#include <algorithm>
#include <cstdlib>
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
using voxel::VoxelKey;

constexpr std::uint32_t kSeeds = 100;
constexpr int kRaysOfSeed = 200;

/** Calls check(ray) for rays of all kinds, within a few voxels of the origin or of another corner
 * of a region, or through several regions. */
template <class Check>
void forManyRays(const Check& check)
{
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::int64_t center = seed % 3 == 0 ? -32768 : seed % 3 == 1 ? 0 : 128;
    RandomRays rays(seed, center - (seed % 5 == 0 ? 20 : 5), center + (seed % 5 == 0 ? 20 : 5));
    for (int i = 0; i < kRaysOfSeed && !::testing::Test::HasFailure(); ++i) check(rays.any());
  }
}

TEST(RayWalk, ComesToTheVoxelsOfAnExactTestOfEveryVoxel)
{
  forManyRays(
      [](const GridRay& ray)
      {
        const auto expected = voxelsOnRay(ray, oracle::boxOf(ray));
        EXPECT_EQ(text(expected), text(voxel::voxelsOnRay(ray))) << text(ray);
      });
}

TEST(RayWalk, ComesToEachVoxelThatHoldsAPointOfTheRayAndTouchesAllOthers)
{
  forManyRays(
      [](const GridRay& ray)
      {
        const auto walked = voxel::voxelsOnRay(ray);
        for (const auto& v : walked) EXPECT_TRUE(oracle::touches(ray, v)) << text(ray) << text({v});
        const auto box = oracle::boxOf(ray);
        for (auto x = box.low[0]; x <= box.high[0]; ++x)
          for (auto y = box.low[1]; y <= box.high[1]; ++y)
            for (auto z = box.low[2]; z <= box.high[2]; ++z)
            {
              const VoxelKey v{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                               static_cast<std::int32_t>(z)};
              if (!oracle::holdsPointOf(ray, v)) continue;
              EXPECT_EQ(1, std::count(walked.begin(), walked.end(), v)) << text(ray) << text({v});
            }
      });
}

TEST(RayWalk, GoesFromTheStartToTheEndOverOneFaceAtATime)
{
  forManyRays(
      [](const GridRay& ray)
      {
        const SeenVoxels seen = seenAs<std::int64_t>(ray);
        EXPECT_EQ(1, seen.ends) << text(ray);
        for (int axis = 0; axis < 3; ++axis)
        {
          const auto i = static_cast<std::size_t>(axis);
          EXPECT_EQ(ray.from[i] >> voxel::kRayBits, keyOn(axis, seen.voxels.front()));
          EXPECT_EQ(ray.to[i] >> voxel::kRayBits, keyOn(axis, seen.voxels.back()));
        }
        for (std::size_t v = 1; v < seen.voxels.size(); ++v)
        {
          std::int64_t steps = 0;
          for (int axis = 0; axis < 3; ++axis)
            steps += std::abs(keyOn(axis, seen.voxels[v]) - keyOn(axis, seen.voxels[v - 1]));
          EXPECT_EQ(1, steps) << text(ray) << text(seen.voxels);
        }
      });
}

TEST(RayWalk, TimesOf64And128BitsTakeTheSameWay)
{
  forManyRays(
      [](const GridRay& ray)
      {
        ASSERT_TRUE(voxel::isShort(ray));
        const SeenVoxels narrow = seenAs<std::int64_t>(ray), wide = seenAs<Wide>(ray);
        EXPECT_EQ(text(narrow.voxels), text(wide.voxels)) << text(ray);
      });
}

TEST(RayWalk, TheLongestShortRaysNeedNoMoreThan64Bits)
{
  constexpr std::int64_t most = std::int64_t{1} << 20;
  RandomRays random(4, -1, 1);
  for (int i = 0; i < 40; ++i)
  {
    GridRay ray = random.anywhere();
    for (std::size_t axis = 0; axis < 3; ++axis)
      ray.to[axis] = ray.from[axis] + (random.between(0, 1) ? 1 : -1) *
                                          (i < 8 ? most : most - random.between(0, most / 100));
    ASSERT_TRUE(voxel::isShort(ray));
    EXPECT_TRUE(seenAs<std::int64_t>(ray).voxels == seenAs<Wide>(ray).voxels) << text(ray);
    ray.to[0] = ray.from[0] + (ray.to[0] > ray.from[0] ? most + 1 : -most - 1);
    EXPECT_FALSE(voxel::isShort(ray));
  }
}

}  // namespace
