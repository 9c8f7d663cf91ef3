// Noise-free planes have one right partition, by what they are made of: full extractions must find
// it, and so must maps that grow scan by scan, whatever the order and the number of threads.
#include <gtest/gtest.h>

#include <string>

#include "../oracle/ExhaustivePlanes.h"
#include "RandomTerrain.h"
#include "TerrainChecks.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainMap;

TEST(TerrainPlanes, NoiseFreePlanesAreFoundInAnyOrder)
{
  for (unsigned seed = 1; seed <= 150 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const RandomTerrain terrain(rng);
    const auto truth = oracle::truePlanes(terrain.labels(), 12);
    TerrainMap full(RandomTerrain::kResolution, RandomTerrain::params());
    full.insert(terrain.points().scan(), {});
    full.extract(1 + static_cast<int>(seed % 3));
    expectPartition(full, truth, "all at once");
    for (int order = 0; order < 2; ++order)
    {
      TerrainMap map(RandomTerrain::kResolution, RandomTerrain::params());
      for (const TerrainPoints& scan : asScans(rng, terrain.points()))
      {
        map.insert(scan.scan(), {});
        if (chance(rng, 80)) map.update(pick(rng, 1, 3));
      }
      map.update(1);
      expectPartition(map, truth, "order " + std::to_string(order));
    }
  }
}

/** Whatever was there before, a full extraction sees but cells. */
TEST(TerrainPlanes, AFullExtractionForgetsHowItCameThere)
{
  for (unsigned seed = 1; seed <= 40 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const TerrainPoints points = RandomTerrain(rng).noisyPoints(rng, 0.01);
    TerrainMap once(RandomTerrain::kResolution, RandomTerrain::params()), grown(once);
    for (const TerrainPoints& scan : asScans(rng, points, 1))
    {
      grown.insert(scan.scan(), {});
      grown.update(1);
    }
    once.insert(points.scan(), {});
    once.extract(2);
    grown.extract(1);
    expectSameMap(grown, once);
  }
}

TEST(TerrainPlanes, AnyNumberOfThreadsGivesTheSame)
{
  for (unsigned seed = 1; seed <= 40 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const TerrainPoints points = RandomTerrain(rng).noisyPoints(rng, 0.005 * pick(rng, 0, 8));
    TerrainMap one(RandomTerrain::kResolution, RandomTerrain::params()), two(one), three(one);
    for (const TerrainPoints& scan : asScans(rng, points))
    {
      for (TerrainMap* map : {&one, &two, &three}) map->insert(scan.scan(), {});
      one.update(1);
      two.update(2);
      three.update(3);
      expectSameMap(two, one);
      expectSameMap(three, one);
    }
  }
}

/** Small maps, whose planes are found by trying all there could be, from heights alone. */
TEST(TerrainPlanes, AgreeWithExhaustiveSearchOnSmallMaps)
{
  for (unsigned seed = 1; seed <= 25 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    TerrainMap map(RandomTerrain::kResolution, RandomTerrain::params());
    oracle::TerrainHeights heights;
    const int xBorder = pick(rng, 4, 7), yBorder = pick(rng, 4, 7);
    const double slope = 0.03 * pick(rng, -1, 1);
    for (int y = 0; y < 10; ++y)
      for (int x = 0; x < 11; ++x)
      {
        if (x == xBorder && y < 3 && chance(rng, 50)) continue;
        const double z = y >= yBorder ? 1 + slope * x : x >= xBorder ? 0.15 : 0;
        map.insertPoint(x * map.resolution(), y * map.resolution(), z, 0.01);
        heights[{y, x}] = map.cell(x, y)->height;
      }
    map.extract(1);
    const auto found = oracle::planesOfCells(map);
    const auto wanted = oracle::exhaustivePlanes(heights, 0.001, map.params().minPlaneCells);
    EXPECT_TRUE(found == wanted) << differences(found, wanted);
  }
}
}  // namespace
