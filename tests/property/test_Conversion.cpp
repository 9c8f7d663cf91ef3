// The library against its brute-force twin, on random maps and on a real one.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelGridSource.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTreeStamped.h>
#include <octomap/octomap.h>

#include <cmath>
#include <filesystem>

#include "../oracle/DenseOracle.h"
#include "CompareLayers.h"
#include "RandomMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;

constexpr double kResolutions[] = {0.05, 0.07, 0.08, 0.3};

/** A whole number of voxels as a user writes it: 0.35 and not 5·0.07. */
double asWritten(int voxels, double res) { return std::round(voxels * res * 100) / 100; }

double randomClearance(Rng& rng, double res)
{
  switch (pick(rng, 0, 4))
  {
    case 0:
      return 0;
    case 1:
      return pick(rng, 1, 20) * res;
    case 2:
      return asWritten(pick(rng, 1, 20), res);
    case 3:
      return uniform(rng, 0, 5);
    default:
      return uniform(rng, 0, 5 * res);
  }
}

double randomStep(Rng& rng, double res)
{
  switch (pick(rng, 0, 3))
  {
    case 0:
      return asWritten(pick(rng, 1, 12), res);
    case 1:
      return uniform(rng, 0, 10 * res);
    default:
      return 0;
  }
}

freespace::ConversionParams randomParams(Rng& rng, double res)
{
  auto params = freespace::ConversionParams::paper();
  params.minClearance = randomClearance(rng, res);
  const double shares[] = {0, 1, 0.5, 0.25, 0.1, 0.3, 0.7};
  params.minOccupancy = chance(rng, 75) ? shares[pick(rng, 0, 6)] : uniform(rng, 0, 1);
  const int wideWindows[] = {19, 20, 21, 40, 100};
  params.slopeWindow = chance(rng, 95) ? pick(rng, 1, 5) : wideWindows[pick(rng, 0, 4)];
  const double slopes[] = {0, 0.5, 1, 1.5, 2, 3, 0.3};
  params.maxSlope = chance(rng, 70) ? slopes[pick(rng, 0, 6)] : uniform(rng, 0, 4);
  if (chance(rng, 85))
    params.maxStep = randomStep(rng, res);
  else
    params.maxStep.reset();
  if (chance(rng, 30)) params.reading.unknown = voxel::Unknown::Free;
  return params;
}

template <class Tree>
class Conversion : public ::testing::Test
{
};
using Trees = ::testing::Types<octomap::OcTree, octomap::ColorOcTree, octomap::OcTreeStamped>;
TYPED_TEST_SUITE(Conversion, Trees);

TYPED_TEST(Conversion, AgreesWithTheOracleOnRandomMaps)
{
  constexpr unsigned kRounds = 1500;
  // every type of tree gets its own maps
  const auto typeSeed = 10000 * static_cast<unsigned>(TypeParam(1.0).getTreeType().size());
  for (unsigned round = 0; round < kRounds && !this->HasFailure(); ++round)
  {
    const unsigned seed = typeSeed + round;
    Rng rng(seed);
    const double res = kResolutions[round % 4];
    const MapShape shape = randomShape(rng);
    TypeParam tree(res);
    randomTree(rng, shape, tree);
    const voxel::OctreeSource<TypeParam> source(tree);
    const voxel::VoxelGrid grid = voxel::toVoxelGrid(tree);
    const voxel::VoxelGridSource gridSource(grid);
    const oracle::DenseMap map = oracle::denseMap(tree);

    for (int i = 0; i < 3; ++i)
    {
      const freespace::ConversionParams params = randomParams(rng, res);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", resolution " + std::to_string(res) + ", " +
                   shape.text() + "; " + text(params));
      const oracle::DenseResult expected = oracle::convert(map, params);
      const freespace::Layers layers = freespace::convert(source, params, 1);
      EXPECT_TRUE(agreesWithOracle(layers, map, expected));
      EXPECT_TRUE(countsAgree(freespace::statistics(layers), expected));
      EXPECT_TRUE(sameBits(layers, freespace::convert(source, params, 2)));
      EXPECT_TRUE(sameBits(layers, freespace::convert(gridSource, params, 2)));
    }
  }
}

/** A column that reaches from one end of the z keys to the other, beside ordinary ones. */
TEST(ConversionExtremes, WholeRangeOfHeights)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    octomap::OcTree tree(0.07);
    for (int i = 0; i < 400; ++i)
    {
      const int kz = chance(rng, 50) ? pick(rng, -32768, -32700) : pick(rng, 32700, 32767);
      tree.setNodeValue(oracle::octomapKey(pick(rng, 30, 33), pick(rng, -2, 1), kz),
                        chance(rng, 70) ? -0.4f : 0.85f, true);
    }
    auto params = freespace::ConversionParams::paper();
    params.minClearance = 0.14;
    params.minOccupancy = 0;
    const oracle::DenseMap map = oracle::denseMap(tree);
    ASSERT_GT(map.nz, 65000);
    const freespace::Layers layers =
        freespace::convert(voxel::OctreeSource<octomap::OcTree>(tree), params, 1);
    EXPECT_TRUE(agreesWithOracle(layers, map, oracle::convert(map, params)));
  }
}

/** The largest moments there can be: wide windows over floors at all heights. */
TEST(ConversionExtremes, WideWindowsOverTheWholeRangeOfFloors)
{
  constexpr int kSide = 230;
  Rng rng(5);
  octomap::OcTree tree(0.05);
  oracle::DenseResult expected;
  expected.nx = expected.ny = kSide;
  expected.cells.resize(std::size_t{kSide} * kSide);
  for (int iy = 0; iy < kSide; ++iy)
    for (int ix = 0; ix < kSide; ++ix)
    {
      oracle::Cell& cell = expected.at(ix, iy);
      cell.free = chance(rng, 95);
      // a cliff, so that the slopes are large, or anything
      cell.floorKey =
          chance(rng, 80) ? (ix + iy < kSide ? -32768 : 32767) : pick(rng, -32768, 32767);
      if (cell.free) tree.setNodeValue(oracle::octomapKey(ix, iy, cell.floorKey), -0.4f, true);
    }
  auto params = freespace::ConversionParams::paper();
  params.minClearance = 0;
  for (const int window : {20, 21, 100})
  {
    params.slopeWindow = window;
    const freespace::Layers layers =
        freespace::convert(voxel::OctreeSource<octomap::OcTree>(tree), params, 2);
    ASSERT_EQ(layers.frame(), (grid::GridFrame{0.05, 0, 0, kSide, kSide}));
    for (int i = 0; i < 150; ++i)
    {
      const int ix = pick(rng, 0, kSide - 1), iy = pick(rng, 0, kSide - 1);
      oracle::fitSlope(window, params.maxSlope, ix, iy, expected);
      const oracle::Cell& cell = expected.at(ix, iy);
      if (!cell.hasSlope) continue;
      const auto slope = static_cast<double>(cell.slope);
      EXPECT_NEAR(layers.slope.at(ix, iy), slope, 1e-6 * slope)
          << "window " << window << ", cell (" << ix << ", " << iy << ")";
    }
  }
}

TEST(ConversionOfRealData, AgreesWithTheOracle)
{
  const std::filesystem::path file = std::filesystem::path(MRPT_MAPCONV_SHARED_DIR) / "geb079.bt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  octomap::OcTree tree(0.1);
  ASSERT_TRUE(tree.readBinary(file.string()));
  const voxel::OctreeSource<octomap::OcTree> source(tree);
  const oracle::DenseMap map = oracle::denseMap(tree);

  for (const double minClearance : {1.0, 0.4})
    for (const double maxStep : {0.0, 0.16})
    {
      auto params = freespace::ConversionParams::paper();
      params.minClearance = minClearance;
      params.maxStep = maxStep;
      SCOPED_TRACE(text(params));
      const oracle::DenseResult expected = oracle::convert(map, params);
      const freespace::Layers layers = freespace::convert(source, params, 2);
      EXPECT_GT(oracle::statistics(expected).free, 3063u);
      EXPECT_TRUE(agreesWithOracle(layers, map, expected));
      EXPECT_TRUE(countsAgree(freespace::statistics(layers), expected));
      EXPECT_TRUE(sameBits(layers, freespace::convert(source, params, 1)));
    }
}

}  // namespace
