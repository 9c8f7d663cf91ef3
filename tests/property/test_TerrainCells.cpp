// Points in cells: random poses, scans and covariances, against each point on its own.
#include <gtest/gtest.h>
#include <mrpt_mapconv/terrain/PlaneFit.h>

#include <cmath>
#include <string>
#include <vector>

#include "../oracle/TerrainCells.h"
#include "RandomTerrain.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using mrpt::poses::CPose3D;
using terrain::TerrainMap;

struct Scan
{
  TerrainPoints points;
  CPose3D sensorPose, robotPose;
  mrpt::math::CMatrixDouble33 covariance;

  terrain::TerrainScan scan() const
  {
    auto scan = points.scan();
    scan.sensorPose = sensorPose;
    scan.robotPose = robotPose;
    scan.poseCovariance = covariance;
    return scan;
  }
};

/** A Aᵀ of a random A. */
mrpt::math::CMatrixDouble33 randomCovariance(Rng& rng)
{
  double a[3][3];
  for (auto& row : a)
    for (double& v : row) v = uniform(rng, -0.02, 0.02);
  mrpt::math::CMatrixDouble33 covariance;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      covariance(i, j) = 0;
      for (int k = 0; k < 3; ++k) covariance(i, j) += a[i][k] * a[j][k];
    }
  return covariance;
}

Scan randomScan(Rng& rng)
{
  Scan scan;
  scan.robotPose = CPose3D(uniform(rng, -50, 50), uniform(rng, -50, 50), uniform(rng, -2, 2),
                           uniform(rng, -3, 3), uniform(rng, -0.5, 0.5), uniform(rng, -0.5, 0.5));
  scan.sensorPose =
      scan.robotPose + CPose3D(uniform(rng, -0.5, 0.5), uniform(rng, -0.5, 0.5), 0.8,
                               uniform(rng, -3, 3), uniform(rng, -1.2, 1.2), uniform(rng, -1, 1));
  scan.covariance = randomCovariance(rng);
  for (int i = pick(rng, 0, 700); i > 0; --i)
  {
    scan.points.x.push_back(static_cast<float>(uniform(rng, -4, 4)));
    scan.points.y.push_back(static_cast<float>(uniform(rng, -4, 4)));
    scan.points.z.push_back(chance(rng, 2) ? NAN : static_cast<float>(uniform(rng, -2, 1)));
  }
  return scan;
}

terrain::PointSigmas randomSigmas(Rng& rng)
{
  terrain::PointSigmas sigmas;
  sigmas.range = uniform(rng, 0, 0.05);
  sigmas.beam = uniform(rng, 0, 0.01);
  return sigmas;
}

/** Cells keep heights in whole units and 1/σ² in sixteenths of 1/m² for each point. */
void expectCells(const TerrainMap& map, const oracle::TerrainCells& wanted)
{
  EXPECT_EQ(map.cells(), wanted.cells().size());
  const bool isFused = map.params().heightRule == terrain::HeightRule::Fused;
  for (const auto& [key, cell] : wanted.cells())
  {
    SCOPED_TRACE("cell (" + std::to_string(key.second) + ", " + std::to_string(key.first) + ")");
    const auto found = map.cell(key.second, key.first);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->points, cell.points);
    const double weight = isFused ? cell.weight : 1 / cell.highestVariance;
    const double rounding = (isFused ? static_cast<double>(cell.points) : 1) * 0.5 / 16,
                 weightError = rounding + 1e-4 * weight;
    EXPECT_NEAR(1 / found->variance, weight, weightError);
    EXPECT_NEAR(found->height, isFused ? cell.fused() : cell.highest,
                terrain::kHeightUnit + (cell.highest - cell.lowest) * weightError / weight);
  }
}

/** The same cells to the last bit. */
void expectSameCells(const TerrainMap& map, const TerrainMap& wanted)
{
  ASSERT_EQ(map.cells(), wanted.cells());
  ASSERT_EQ(map.frame(), wanted.frame());
  const auto frame = wanted.frame();
  for (int y = frame.y0; y < frame.yEnd(); ++y)
    for (int x = frame.x0; x < frame.xEnd(); ++x)
    {
      const auto a = map.cell(x, y), b = wanted.cell(x, y);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (!a) continue;
      ASSERT_EQ(a->points, b->points);
      ASSERT_EQ(a->height, b->height);
      ASSERT_EQ(a->variance, b->variance);
    }
}

terrain::TerrainParams withRule(terrain::HeightRule rule)
{
  terrain::TerrainParams params;
  params.heightRule = rule;
  return params;
}

TEST(TerrainCells, AreThoseOfEachPointOnItsOwn)
{
  for (unsigned seed = 1; seed <= 60 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    constexpr double kResolutions[] = {0.05, 0.1, 0.3, 1};
    const double resolution = kResolutions[seed % 4];
    TerrainMap map(resolution, withRule(seed % 3 == 0 ? terrain::HeightRule::Maximum
                                                      : terrain::HeightRule::Fused));
    oracle::TerrainCells wanted(resolution);
    const auto sigmas = randomSigmas(rng);
    for (int scans = pick(rng, 1, 4); scans > 0; --scans)
    {
      const Scan scan = randomScan(rng);
      map.insert(scan.scan(), sigmas);
      wanted.insert(scan.scan(), sigmas);
    }
    expectCells(map, wanted);
  }
}

TEST(TerrainCells, DoNotDependOnTheOrderOfScansAndPoints)
{
  for (unsigned seed = 1; seed <= 40 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const auto params =
        withRule(seed % 2 ? terrain::HeightRule::Maximum : terrain::HeightRule::Fused);
    const auto sigmas = randomSigmas(rng);
    std::vector<Scan> scans(static_cast<std::size_t>(pick(rng, 2, 5)));
    for (Scan& scan : scans) scan = randomScan(rng);
    TerrainMap map(0.2, params), other(0.2, params);
    for (const Scan& scan : scans) map.insert(scan.scan(), sigmas);
    for (auto scan = scans.rbegin(); scan != scans.rend(); ++scan)
    {
      shuffle(rng, scan->points);
      other.insert(scan->scan(), sigmas);
      if (chance(rng, 50)) other.update(1);
    }
    expectSameCells(other, map);
  }
}
}  // namespace
