// Floors with evidence: the library against its brute-force twin, on random maps made for it, and
// against itself on turned and mirrored maps.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/octomap.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "CompareLayers.h"
#include "DenseSource.h"
#include "RandomGround.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using freespace::ConversionParams;
using freespace::Layers;
using oracle::DenseMap;

constexpr double kResolutions[] = {0.05, 0.07, 0.1, 0.15, 0.2, 0.25, 0.3, 0.5, 1.0, 1.7};

double resolutionOf(unsigned round) { return kResolutions[round % std::size(kResolutions)]; }

std::string about(unsigned seed, const DenseMap& map, const ConversionParams& params)
{
  return "seed " + std::to_string(seed) + ", resolution " + std::to_string(map.resolution) + ", " +
         std::to_string(map.nx) + "x" + std::to_string(map.ny) + "; " + text(params);
}

/** How often what the tests are about was met. */
struct Met
{
  std::size_t inferred = 0, frontier = 0, aboveFloor = 0, drops = 0;

  void add(const oracle::DenseResult& result)
  {
    for (const oracle::Cell& cell : result.cells)
    {
      inferred += cell.evidence == oracle::Evidence::Inferred;
      frontier += cell.evidence == oracle::Evidence::Open;
      aboveFloor += cell.hasSupport && cell.support64 > 64 * std::int64_t{cell.floorKey};
      drops += cell.isDrop && !cell.isStep;
    }
  }
};

TEST(Evidence, AgreesWithTheOracleOnRandomGround)
{
  Met met;
  for (unsigned seed = 1; seed <= 1500 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const DenseMap map = trimmed(randomGround(rng, resolutionOf(seed)));
    const DenseSource source(map);
    for (int i = 0; i < 3; ++i)
    {
      const ConversionParams params = randomGroundParams(rng, map.resolution);
      SCOPED_TRACE(about(seed, map, params));
      const oracle::DenseResult expected = oracle::convert(map, params);
      const Layers layers = freespace::convert(source, params, 1);
      EXPECT_TRUE(agreesWithOracle(layers, map, expected));
      EXPECT_TRUE(countsAgree(freespace::statistics(layers), expected));
      EXPECT_TRUE(sameBits(layers, freespace::convert(source, params, pick(rng, 2, 4))));
      met.add(expected);
    }
  }
  EXPECT_GT(met.inferred, 100'000u);
  EXPECT_GT(met.frontier, 100'000u);
  EXPECT_GT(met.aboveFloor, 5'000u);
  EXPECT_GT(met.drops, 1'000u);
}

/** Only over gaps of 128 cells does a line meet halves of 64ths of voxels. */
TEST(Evidence, AgreesWithTheOracleOverGapsOf128Cells)
{
  for (unsigned seed = 1; seed <= 30 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    DenseMap map;
    map.resolution = 0.05;
    map.x0 = pick(rng, -300, 300), map.z0 = pick(rng, -60, 20);
    map.nx = pick(rng, 200, 300), map.ny = pick(rng, 1, 3), map.nz = 40;
    map.voxels.assign(static_cast<std::size_t>(map.nx * map.ny * map.nz), oracle::Voxel::Unknown);
    for (int iy = 0; iy < map.ny; ++iy)
    {
      const int first = pick(rng, 0, 60);
      for (int ix = 0; ix < map.nx; ++ix)
        setColumn(rng, map, ix, iy, (ix - first) % 128 == 0 ? ColumnKind::Seen : ColumnKind::Open,
                  pick(rng, 15, 17));
    }
    ConversionParams params = randomGroundParams(rng, map.resolution);
    params.minClearance = 0.1;
    params.maxStep = 0.1;
    params.maxGap = 128 * map.resolution;
    SCOPED_TRACE(about(seed, map, params));
    EXPECT_TRUE(agreesWithOracle(freespace::convert(DenseSource(map), params, 1), map,
                                 oracle::convert(map, params)));
  }
}

/** Of maps that were not made for it: all kinds of RandomMap. */
TEST(Evidence, AgreesWithTheOracleOnAnyRandomMap)
{
  for (unsigned seed = 1; seed <= 400 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    octomap::OcTree tree(resolutionOf(seed));
    randomTree(rng, randomShape(rng), tree);
    const DenseMap map = oracle::denseMap(tree);
    const ConversionParams params = randomGroundParams(rng, map.resolution);
    SCOPED_TRACE(about(seed, map, params));
    const oracle::DenseResult expected = oracle::convert(map, params);
    const Layers layers = freespace::convert(voxel::OctreeSource<octomap::OcTree>(tree), params, 1);
    EXPECT_TRUE(agreesWithOracle(layers, map, expected));
    EXPECT_TRUE(countsAgree(freespace::statistics(layers), expected));
  }
}

/** lowestFree is the paper: the ground is the floor, and all else is what the twin of old says. */
TEST(Evidence, LowestFreeTakesTheFloorForTheGround)
{
  for (unsigned seed = 1; seed <= 100 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const DenseMap map = trimmed(randomGround(rng, resolutionOf(seed)));
    ConversionParams params = randomGroundParams(rng, map.resolution);
    params.floorFrom = freespace::FloorFrom::LowestFree;
    SCOPED_TRACE(about(seed, map, params));
    const Layers layers = freespace::convert(DenseSource(map), params, 2);
    EXPECT_TRUE(agreesWithOracle(layers, map, oracle::convert(map, params)));
    for (std::size_t i = 0; i < layers.floor.cells().size(); ++i)
    {
      const float floor = layers.floor.cells()[i], support = layers.support.cells()[i];
      EXPECT_TRUE(support == floor || (std::isnan(support) && std::isnan(floor)));
    }
  }
}

// ---- turned and mirrored

/** One of the eight ways in which a square lies on itself. */
struct Symmetry
{
  bool swap, flipX, flipY;  //!< swap goes first

  int width(const DenseMap& map) const { return swap ? map.ny : map.nx; }
  int height(const DenseMap& map) const { return swap ? map.nx : map.ny; }
  /** Where a column of the map comes to lie. */
  std::pair<int, int> operator()(const DenseMap& map, int ix, int iy) const
  {
    const int x = swap ? iy : ix, y = swap ? ix : iy;
    return {flipX ? width(map) - 1 - x : x, flipY ? height(map) - 1 - y : y};
  }
};

DenseMap moved(const DenseMap& map, const Symmetry& symmetry)
{
  DenseMap out = map;  // the first key stays, so that the blocks cut elsewhere
  out.nx = symmetry.width(map), out.ny = symmetry.height(map);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      const auto [x, y] = symmetry(map, ix, iy);
      for (int iz = 0; iz < map.nz; ++iz) out.at(x, y, iz) = map.at(ix, iy, iz);
    }
  return out;
}

Layers movedLayers(const Layers& layers, const DenseMap& map, const Symmetry& symmetry,
                   const grid::GridFrame& frame)
{
  Layers out(frame);
  for (const auto& entry : Layers::list())
    for (int iy = 0; iy < map.ny; ++iy)
      for (int ix = 0; ix < map.nx; ++ix)
      {
        const auto [x, y] = symmetry(map, ix, iy);
        (out.*entry.member).at(x, y) = (layers.*entry.member).at(ix, iy);
      }
  return out;
}

TEST(Evidence, TurnedAndMirroredMapsGiveTurnedAndMirroredLayers)
{
  for (unsigned seed = 1; seed <= 200 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const DenseMap map = trimmed(randomGround(rng, resolutionOf(seed)));
    const ConversionParams params = randomGroundParams(rng, map.resolution);
    const Layers layers = freespace::convert(DenseSource(map), params, 1);
    for (int which = 1; which < 8; ++which)
    {
      const Symmetry symmetry{(which & 4) != 0, (which & 1) != 0, (which & 2) != 0};
      SCOPED_TRACE(about(seed, map, params) + ", symmetry " + std::to_string(which));
      const DenseMap other = moved(map, symmetry);
      const Layers got = freespace::convert(DenseSource(other), params, 1);
      EXPECT_TRUE(sameBits(got, movedLayers(layers, map, symmetry, got.frame())));
    }
  }
}

}  // namespace
