// Noise and rubble have no one right partition, but some things hold of any.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "RandomTerrain.h"
#include "TerrainChecks.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainMap;

terrain::TerrainParams randomParams(Rng& rng)
{
  terrain::TerrainParams params;
  params.planeTolerance = 0.01 * pick(rng, 1, 6);
  params.planeWindow = 0.05 * pick(rng, 0, 12);
  params.hypotheses = pick(rng, 1, 64);
  params.blockCells = pick(rng, 1, 40);
  params.minPlaneCells = pick(rng, 3, 40);
  params.maxPlaneSlope = uniform(rng, 0.1, 2);
  params.maxSlope = std::min(params.maxSlope, params.maxPlaneSlope);
  if (chance(rng, 30)) params.heightRule = terrain::HeightRule::Maximum;
  return params;
}

/** What a sensor sees anew of a terrain that has changed here and there. */
TerrainPoints edited(Rng& rng, const TerrainPoints& points)
{
  TerrainPoints edit;
  const auto middle = static_cast<std::size_t>(pick(rng, 0, static_cast<int>(points.size()) - 1));
  const double reach = uniform(rng, 0.1, 1.5), rise = chance(rng, 50) ? uniform(rng, -1, 1) : 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (std::hypot(points.x[i] - points.x[middle], points.y[i] - points.y[middle]) > reach)
      continue;
    for (int times = pick(rng, 1, 6); times > 0; --times)
    {
      edit.x.push_back(points.x[i]);
      edit.y.push_back(points.y[i]);
      edit.z.push_back(points.z[i] + static_cast<float>(rise + uniform(rng, -0.02, 0.02)));
    }
  }
  return edit;
}

TEST(TerrainNoise, PlanesAndLeavesAreConsistentAfterAnyEdit)
{
  for (unsigned seed = 1; seed <= 40 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const RandomTerrain terrain(rng);
    const auto params = randomParams(rng);
    TerrainMap map(RandomTerrain::kResolution, params);
    const TerrainPoints points = terrain.noisyPoints(rng, 0.004 * pick(rng, 0, 8));
    map.insert(points.scan(), {});
    map.update(1);
    expectInvariants(map);
    for (int step = 1; step <= 6 && !HasFailure(); ++step)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      map.insert(edited(rng, points).scan(), {});
      map.update(pick(rng, 1, 3));
      expectInvariants(map);
    }
    map.extract(1);
    expectInvariants(map);
  }
}

/** The window drives over the terrain and back, and sees some of it again. */
TEST(TerrainNoise, PlanesAndLeavesAreConsistentInALocalWindow)
{
  for (unsigned seed = 1; seed <= 40 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const RandomTerrain terrain(rng);
    auto params = randomParams(rng);
    params.localWindow = uniform(rng, 0.5, 4);
    TerrainMap map(RandomTerrain::kResolution, params);
    const TerrainPoints points = terrain.noisyPoints(rng, 0.002 * pick(rng, 0, 5));
    for (int step = 1; step <= 8 && !HasFailure(); ++step)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      const auto at = static_cast<std::size_t>(pick(rng, 0, static_cast<int>(points.size()) - 1));
      const TerrainPoints seen = chance(rng, 30) ? TerrainPoints() : edited(rng, points);
      auto scan = seen.scan();
      scan.robotPose = mrpt::poses::CPose3D(static_cast<double>(points.x[at]),
                                            static_cast<double>(points.y[at]), 0, 0, 0, 0);
      map.insert(scan, {});
      map.update(pick(rng, 1, 3));
      expectInvariants(map);
    }
  }
}

/** Copies go on as the maps that they are of. */
TEST(TerrainNoise, CopiesGoOnAlike)
{
  for (unsigned seed = 1; seed <= 20 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const TerrainPoints points = RandomTerrain(rng).noisyPoints(rng, 0.01);
    TerrainMap map(RandomTerrain::kResolution, RandomTerrain::params());
    for (const TerrainPoints& scan : asScans(rng, points))
    {
      TerrainMap copy(map);
      map.insert(scan.scan(), {});
      map.update(1);
      copy.insert(scan.scan(), {});
      copy.update(1);
      expectSameMap(copy, map);
    }
  }
}
}  // namespace
