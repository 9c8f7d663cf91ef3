// Rays that are inserted by any number of threads do what they do one after the other to an array.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/RayInsertion.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "RandomRays.h"
#include "oracle/DenseGrid.h"
#include "support/GridBytes.h"

namespace
{
using namespace mrpt_mapconv;
using mrpt::math::TPoint3D;
using oracle::DenseGrid;
using test::RandomRays;
using voxel::Ray;
using voxel::RayEnd;
using voxel::RayParams;
using voxel::VoxelGrid;
using voxel::VoxelKey;

using Rays = std::vector<Ray>;
constexpr double kResolution = 0.25;  // a power of two: units of rays are exact in metres
constexpr std::array<int, 5> kThreads{1, 2, 3, 8, 0};

/** The same rays in the array and, by several numbers of threads, in grids. */
class Twins
{
 public:
  Twins(double resolution, std::int64_t low, std::int64_t high)
      : m_dense(resolution, {{low, low, low}, {high - 1, high - 1, high - 1}}),
        m_grids(kThreads.size(), VoxelGrid(resolution))
  {
  }

  void insert(const Rays& rays, const RayParams& params)
  {
    const std::size_t updates = m_dense.updates, notFinite = m_dense.notFinite;
    m_dense.insert(rays, params);
    std::vector<voxel::InsertedRays> inserted;
    for (std::size_t t = 0; t < kThreads.size(); ++t)
    {
      SCOPED_TRACE(std::to_string(kThreads[t]) + " threads");
      inserted.push_back(insertRays(m_grids[t], rays, params, kThreads[t]));
      EXPECT_EQ(m_dense.notFinite - notFinite, inserted[t].notFinite);
      EXPECT_EQ(rays.size() - inserted[t].notFinite, inserted[t].rays);
      EXPECT_EQ(m_dense.updates - updates, inserted[t].updates);
      EXPECT_EQ(inserted[0].columns.size(), inserted[t].columns.size());
      inserted[t].columns.forEach([&](int x, int y)
                                  { EXPECT_TRUE(inserted[0].columns.contains(x, y)); });
      EXPECT_TRUE(test::bytesOf(m_grids[0]) == test::bytesOf(m_grids[t]));
    }
    compareToArray();
  }

  /** How many bricks are kept as one known value. */
  int uniformBricks() const
  {
    int count = 0;
    m_grids[0].table().forEachSlot(
        [&](const VoxelKey&, const VoxelGrid::Slot& slot)
        { count += !slot.brick && voxel::isTouched(slot.value) ? 1 : 0; });
    return count;
  }

 private:
  void compareToArray() const
  {
    const auto& box = m_dense.box();
    std::size_t touched = 0, differing = 0;
    for (auto x = box.low[0]; x <= box.high[0]; ++x)
      for (auto y = box.low[1]; y <= box.high[1]; ++y)
        for (auto z = box.low[2]; z <= box.high[2]; ++z)
        {
          const VoxelKey key{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                             static_cast<std::int32_t>(z)};
          const auto& expected = m_dense.at(key);
          const float actual = m_grids[0].logOdds(key);
          touched += expected ? 1 : 0;
          const bool same = expected ? voxel::isTouched(actual) && actual == *expected
                                     : !voxel::isTouched(actual);
          if (same || ++differing > 3) continue;
          ADD_FAILURE() << "voxel " << x << ' ' << y << ' ' << z << ": " << actual << ", but "
                        << (expected ? std::to_string(*expected) : "unknown") << " in the array";
        }
    EXPECT_EQ(0u, differing);
    EXPECT_EQ(touched, m_grids[0].size());
  }

  DenseGrid m_dense;
  std::vector<VoxelGrid> m_grids;
};

RayEnd anyEnd(RandomRays& random) { return static_cast<RayEnd>(random.between(0, 2)); }

Rays raysOfAllKinds(RandomRays& random, int count, double resolution = kResolution)
{
  Rays rays;
  while (count-- > 0) rays.push_back(test::inMetres(random.any(), resolution, anyEnd(random)));
  return rays;
}

RayParams anyParams(RandomRays& random)
{
  const auto share = [&](double low, double high)
  { return low + (high - low) * static_cast<double>(random.between(0, 1000)) / 1000; };
  RayParams params;
  if (random.between(0, 1)) return params;
  params.probHit = share(0.5, 0.99);
  params.probMiss = share(0.05, 0.49);
  params.minLogOdds = share(-4, 0);
  params.maxLogOdds = share(0.1, 4);
  // such that no cut comes to lie halfway between two units
  if (random.between(0, 1)) params.maxRange = share(1, 4) + 0.0001234567;
  return params;
}

/** Rays along an axis that clear each voxel of a cube. */
Rays sweep(int axis, int low, int high)
{
  Rays rays;
  const auto metres = [](int key) { return (key + 0.5) * kResolution; };
  for (int u = low; u < high; ++u)
    for (int v = low; v < high; ++v)
    {
      TPoint3D from(metres(u), metres(u), metres(u));
      from[(axis + 1) % 3] = metres(v);
      TPoint3D to = from;
      from[axis] = metres(low);
      to[axis] = metres(high - 1);
      rays.push_back({from, to, RayEnd::Clear});
    }
  return rays;
}

TEST(RayInsertion, IsThatOfOneRayAfterTheOtherForAnyNumberOfThreads)
{
  for (std::uint32_t seed = 1; seed <= 10; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomRays random(seed, -20, 20);
    Twins twins(kResolution, -20, 20);
    for (int round = 0; round < 3; ++round)
      twins.insert(raysOfAllKinds(random, round == 2 ? 100 : 1500), anyParams(random));
  }
}

TEST(RayInsertion, KeepsTheOrderWhereManyRaysMeetInFewVoxels)
{
  for (std::uint32_t seed = 1; seed <= 10; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomRays random(seed, -2, 2);
    Twins twins(kResolution, -2, 2);
    for (int round = 0; round < 3; ++round)
      twins.insert(raysOfAllKinds(random, 5000), anyParams(random));
  }
}

TEST(RayInsertion, OfBricksThatAreAsFreeAsCanBe)
{
  for (std::uint32_t seed = 1; seed <= 3; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomRays random(seed, -20, 20);
    Twins twins(kResolution, -20, 20);
    RayParams quick;
    quick.probMiss = 0.2;
    const auto clear = [&]
    {
      for (int pass = 0; pass < 2; ++pass)
        twins.insert(sweep(static_cast<int>(random.between(0, 2)), -16, 16), quick);
    };
    clear();
    EXPECT_EQ(8, twins.uniformBricks());
    twins.insert(raysOfAllKinds(random, 40), quick);
    EXPECT_LT(twins.uniformBricks(), 8);
    clear();
    clear();
    twins.insert(raysOfAllKinds(random, 1000), anyParams(random));
  }
}

TEST(RayInsertion, OfBricksThatAreAsFreeAsAnotherLimitAllowed)
{
  Twins twins(kResolution, -20, 20);
  RayParams params;
  for (const double limit : {-0.5, -1.0, -0.3})
  {
    params.minLogOdds = limit;
    params.probMiss = 0.2;
    twins.insert(sweep(2, -16, 16), params);
    EXPECT_EQ(8, twins.uniformBricks()) << limit;
  }
}

TEST(RayInsertion, SkipsRaysThatAreNotFinite)
{
  constexpr double bad[] = {std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity()};
  RandomRays random(3, -8, 8);
  Twins twins(kResolution, -8, 8);
  Rays rays = raysOfAllKinds(random, 1200);
  for (auto& ray : rays)
    if (random.between(0, 4) == 0)
      (random.between(0, 1) ? ray.origin : ray.end)[static_cast<int>(random.between(0, 2))] =
          bad[random.between(0, 2)];
  twins.insert(rays, {});
}

TEST(RayInsertion, OfMetresThatLieOnNoUnit)
{
  for (const double resolution : {0.1, 0.2, 0.07})
  {
    SCOPED_TRACE(resolution);
    RandomRays random(static_cast<std::uint32_t>(resolution * 100), -20, 20);
    Twins twins(resolution, -21, 21);
    const auto metres = [&] {
      return static_cast<double>(random.between(-2'000'000'000, 2'000'000'000)) * 1e-8 * resolution;
    };
    Rays rays;
    for (int i = 0; i < 1000; ++i)
      rays.push_back(
          {{metres(), metres(), metres()}, {metres(), metres(), metres()}, anyEnd(random)});
    RayParams params;
    params.maxRange = 11.1234567 * resolution;
    twins.insert(rays, params);
  }
}
}  // namespace
