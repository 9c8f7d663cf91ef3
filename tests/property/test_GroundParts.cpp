// What the ground filters are made of, against brute force on random clouds and surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../mrpt_mapconv/src/aerial/Cloth.h"
#include "../mrpt_mapconv/src/aerial/DiscOpening.h"
#include "../mrpt_mapconv/src/aerial/EmptyCells.h"
#include "../mrpt_mapconv/src/aerial/LowPoints.h"
#include "../mrpt_mapconv/src/aerial/LowestPoints.h"
#include "../oracle/GroundOracle.h"
#include "RandomCloud.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using aerial::CollisionRule;
using grid::Layer;

constexpr unsigned kSeeds = 30;

/** Calls test(rng) with each seed, which failures name. */
template <class Test>
void forSeeds(const Test& test)
{
  for (unsigned seed = 1; seed <= kSeeds; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    test(rng);
  }
}

Layer<float> randomSurface(Rng& rng)
{
  return randomHeights(rng, pick(rng, 1, 90), pick(rng, 1, 90), 0);
}

void expectSame(const Layer<float>& a, const Layer<float>& b)
{
  for (std::size_t i = 0; i < a.cells().size(); ++i)
  {
    if (std::isnan(a.cells()[i]) && std::isnan(b.cells()[i])) continue;
    ASSERT_EQ(a.cells()[i], b.cells()[i]) << "cell " << i;
  }
}
}  // namespace

TEST(GroundParts, CellsHaveTheLowestOrTheNearestPoint)
{
  forSeeds(
      [](Rng& rng)
      {
        const auto cloud = randomCloud(rng, 300, 12);
        auto used = aerial::usablePoints(cloud);
        for (auto& point : used) point = chance(rng, 90);
        used[0] = 1;
        const auto frame = aerial::frameAround(cloud, used, {0.5, "", aerial::kCentred, 2});
        for (const auto rule : {CollisionRule::Lowest, CollisionRule::Nearest})
          expectSame(aerial::heightsOfCells(cloud, used, frame, rule),
                     oracle::pointHeights(cloud, used, frame, rule));
      });
}

TEST(GroundParts, TheNearestMeasuredCellIsTheNearestOfAll)
{
  forSeeds(
      [](Rng& rng)
      {
        const auto heights =
            randomHeights(rng, pick(rng, 1, 40), pick(rng, 1, 40), pick(rng, 0, 100));
        const auto nearest = aerial::nearestMeasured(heights, 2);
        for (std::size_t cell = 0; cell < nearest.size(); ++cell)
          ASSERT_EQ(nearest[cell], oracle::nearestWithHeight(heights, cell)) << "cell " << cell;
      });
}

TEST(GroundParts, EmptyCellsLieOnTheMembraneToAMillimetre)
{
  forSeeds(
      [](Rng& rng)
      {
        const auto heights =
            randomHeights(rng, pick(rng, 1, 60), pick(rng, 1, 60), pick(rng, 1, 98));
        auto filled = heights;
        aerial::fillEmptyCells(filled, 2);
        const auto right = oracle::membrane(heights);
        for (std::size_t i = 0; i < filled.cells().size(); ++i)
          ASSERT_NEAR(filled.cells()[i], right.cells()[i], 1e-3) << "cell " << i;
      });
}

TEST(GroundParts, OpeningsAreThoseOfTheDefinition)
{
  forSeeds(
      [](Rng& rng)
      {
        const auto surface = randomHeights(rng, pick(rng, 1, 25), pick(rng, 1, 25), 0);
        const int radius = pick(rng, 1, 7);
        expectSame(aerial::openWithDisc(surface, radius, 2), oracle::opening(surface, radius));
      });
}

TEST(GroundParts, LowPointsAreThoseWithoutCompany)
{
  forSeeds(
      [](Rng& rng)
      {
        const auto cloud = randomCloud(rng, pick(rng, 1, 600), pick(rng, 5, 60));
        aerial::GroundParams params;
        params.lowPointRadius = uniform(rng, 2, 10);
        params.lowPointShare = uniform(rng, 0, 0.05);
        auto used = aerial::usablePoints(cloud);
        aerial::leaveOutLowPoints(cloud, params, 2, used);
        auto right = aerial::usablePoints(cloud);
        const double distance = aerial::meanDistance(cloud, right);
        for (const std::size_t point : oracle::lonePoints(cloud, params, distance))
          right[point] = 0;
        ASSERT_EQ(used, right);
      });
}

TEST(GroundParts, AClothLiesWhereOneOfSingleParticlesDoes)
{
  forSeeds(
      [](Rng& rng)
      {
        const auto surface = randomSurface(rng);
        aerial::GroundParams params;
        params.rigidness = pick(rng, 1, 4);
        params.maxIterations = pick(rng, 1, 60);
        aerial::Cloth cloth(surface, params, 2);
        cloth.settle();
        const auto heights = cloth.heights();
        const auto right = oracle::settledCloth(surface, params);
        for (std::size_t i = 0; i < heights.cells().size(); ++i)
          ASSERT_NEAR(heights.cells()[i], right.cells()[i], 2e-3) << "particle " << i;
      });
}
