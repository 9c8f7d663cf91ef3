// The fixed projection against its brute-force twin.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/octomap.h>

#include <limits>

#include "../oracle/DenseOracle.h"
#include "MapEditor.h"
#include "RandomMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Interval
{
  double zMin, zMax;
};

/** A height [m] in or around the map: on a voxel's face, or well inside a voxel. */
double randomHeight(Rng& rng, const MapShape& shape, double res)
{
  const int face = shape.z0 + pick(rng, -3, shape.nz + 3);
  return chance(rng, 50) ? face * res : (face + uniform(rng, 0.01, 0.99)) * res;
}

Interval randomInterval(Rng& rng, const MapShape& shape, double res)
{
  Interval z{};
  do z = {randomHeight(rng, shape, res), randomHeight(rng, shape, res)};
  while (!(z.zMin < z.zMax));
  if (chance(rng, 15)) z.zMin = -kInfinity;
  if (chance(rng, 15)) z.zMax = kInfinity;
  return z;
}

::testing::AssertionResult agrees(const grid::Layer<float>& layer, const oracle::DenseMap& map,
                                  const Interval& z)
{
  const grid::GridFrame wanted{map.resolution, map.x0, map.y0, map.nx, map.ny};
  if (layer.frame() != wanted) return ::testing::AssertionFailure() << "wrong frame";
  const std::vector<int> expected = oracle::projectFixed(map, z.zMin, z.zMax);
  for (std::size_t c = 0; c < expected.size(); ++c)
    if (layer.cells()[c] != static_cast<float>(expected[c]))
      return ::testing::AssertionFailure() << "cell " << c << " of width " << map.nx << ": "
                                           << layer.cells()[c] << ", expected " << expected[c];
  return ::testing::AssertionSuccess();
}

TEST(FixedProjection, AgreesWithTheOracleOnRandomMaps)
{
  constexpr double kResolutions[] = {0.05, 0.07, 0.08, 0.3, 0.1};
  for (unsigned seed = 1; seed <= 400 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const double res = kResolutions[seed % 5];
    const MapShape shape = randomShape(rng);
    octomap::OcTree tree(res);
    randomTree(rng, shape, tree);
    const voxel::OctreeSource<octomap::OcTree> source(tree);
    const oracle::DenseMap map = oracle::denseMap(tree);
    for (int i = 0; i < 8; ++i)
    {
      const Interval z = i == 0 ? Interval{-kInfinity, kInfinity} : randomInterval(rng, shape, res);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", resolution " + std::to_string(res) + ", " +
                   shape.text() + "; z " + std::to_string(z.zMin) + " to " +
                   std::to_string(z.zMax));
      const grid::Layer<float> one = freespace::projectFixed(source, z.zMin, z.zMax, 1);
      EXPECT_TRUE(agrees(one, map, z));
      EXPECT_EQ(one.cells(), freespace::projectFixed(source, z.zMin, z.zMax, 2).cells());
    }
  }
}

/** Heights as a user writes them lie on voxel faces only nearly: 0.3 is not 3·0.1 in double. */
TEST(FixedProjection, DecimalHeightsLieOnFaces)
{
  for (unsigned seed = 1; seed <= 10 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    MapShape shape;
    shape.kind = MapKind::Columns;
    shape.nx = shape.ny = 12, shape.nz = 40, shape.z0 = -20;
    octomap::OcTree tree(0.1);
    randomTree(rng, shape, tree);
    const voxel::OctreeSource<octomap::OcTree> source(tree);
    const oracle::DenseMap map = oracle::denseMap(tree);
    for (const Interval z : {Interval{-1.1, 0.3}, {0.3, 0.6}, {-0.7, 0.7}, {0.6, 1.7}, {0.3, 0.4}})
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", z " + std::to_string(z.zMin) + " to " +
                   std::to_string(z.zMax));
      EXPECT_TRUE(agrees(freespace::projectFixed(source, z.zMin, z.zMax, 1), map, z));
    }
  }
}

/** A layer that follows a changing map holds what a projection of the whole map gives, and nothing
 * else. */
TEST(FixedProjection, UpdatesEqualProjectionsOfTheWholeMap)
{
  for (unsigned seed = 1; seed <= 40 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    MapEditor editor(rng, 0.1, pick(rng, -200, 200), pick(rng, -200, 200), -10);
    const voxel::OctreeSource<octomap::OcTree> source(editor.tree());
    const double zMin = chance(rng, 30) ? -kInfinity : pick(rng, -15, 15) * 0.1;
    const double zMax = chance(rng, 30) ? kInfinity : zMin + 0.5;
    grid::Layer<float> followed;
    if (!(zMin < zMax)) continue;
    freespace::updateFixed(source, voxel::ColumnSet::of(freespace::frameOf(source)), zMin, zMax,
                           followed, 1);
    for (int step = 1; step <= 20 && !HasFailure(); ++step)
    {
      freespace::updateFixed(source, editor.edit(), zMin, zMax, followed, 2);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step) + ": " +
                   editor.lastEdit());
      grid::Layer<float> whole;
      if (source.bounds()) whole = freespace::projectFixed(source, zMin, zMax, 1);
      EXPECT_EQ(followed.frame(), unite(followed.frame(), whole.frame()));
      EXPECT_EQ(followed.cells(), whole.onFrame(followed.frame(), grid::kUnknown).cells());
    }
  }
}

}  // namespace
