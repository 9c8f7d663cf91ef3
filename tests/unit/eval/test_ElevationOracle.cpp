#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/ElevationMap.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "oracle/ElevationOracle.h"

// The map and its fusion against their slow twins.
using namespace mrpt_mapconv;
using eval::ElevationMap;
using eval::ElevationMapParams;
using mrpt::poses::CPose3D;
using oracle::SlowElevationMap;

namespace
{
/** Steps of 0.1 m height with noise, seen by a robot that is somewhere else each time. */
struct RandomScan
{
  explicit RandomScan(std::mt19937& random)
  {
    std::uniform_real_distribution<double> share(-1, 1);
    std::normal_distribution<double> noise(0, 0.02);
    robot = CPose3D(3 * share(random), 3 * share(random), 0.5 + 0.1 * share(random),
                    3 * share(random), 0.3 * share(random), 0.3 * share(random));
    sensor = robot + CPose3D(0.2, 0.1, 0.3, 0.5, 0.4, 0.1);
    for (int i = 0; i < 3000; ++i)
    {
      mrpt::math::TPoint3D place(sensor.x() + 2 * share(random), sensor.y() + 2 * share(random), 0);
      place.z = 0.1 * std::round(2 * std::sin(place.x)) + noise(random);
      const mrpt::math::TPoint3D p = sensor.inverseComposePoint(place);
      x.push_back(static_cast<float>(p.x));
      y.push_back(static_cast<float>(p.y));
      z.push_back(static_cast<float>(p.z));
    }
  }
  terrain::TerrainScan scan() const
  {
    terrain::TerrainScan scan;
    scan.x = x.data();
    scan.y = y.data();
    scan.z = z.data();
    scan.points = x.size();
    scan.sensorPose = sensor;
    scan.robotPose = robot;
    scan.poseCovariance = terrain::PointSigmas{}.poseCovariance();
    scan.poseCovariance(0, 1) = scan.poseCovariance(1, 0) = 2e-6;
    scan.poseCovariance(1, 2) = scan.poseCovariance(2, 1) = 1e-6;
    return scan;
  }

  std::vector<float> x, y, z;
  CPose3D robot, sensor;
};

void expectSame(const ElevationMap& fast, const SlowElevationMap& slow)
{
  const auto height = fast.height(), variance = fast.variance();
  std::size_t known = 0;
  for (const float cell : height.cells()) known += std::isfinite(cell) ? 1 : 0;
  ASSERT_EQ(known, slow.cells.size());
  for (const auto& [key, cell] : slow.cells)
  {
    ASSERT_TRUE(fast.frame().containsKey(key.first, key.second));
    const auto index = fast.frame().indexOfKey(key.first, key.second);
    ASSERT_NEAR(height.cells()[index], cell.height, 1e-4) << key.first << " " << key.second;
    ASSERT_NEAR(variance.cells()[index], cell.variance, 1e-2 * cell.variance);
  }
}

void compareWithSlowOne(double resolution, const ElevationMapParams& params)
{
  const unsigned seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  ElevationMap fast(resolution, params);
  SlowElevationMap slow(resolution, params);
  const terrain::PointSigmas sigmas;
  for (int i = 0; i < 8; ++i)
  {
    const RandomScan scan(random);
    EXPECT_EQ(fast.insert(scan.scan(), sigmas).inserted, 3000u);
    slow.insert(scan.scan(), sigmas);
    expectSame(fast, slow);
  }
}

}  // namespace

TEST(ElevationOracle, UpdatesAreThoseOfTheSlowOne)
{
  for (const double resolution : {0.02, 0.1, 0.37}) compareWithSlowOne(resolution, {});
  ElevationMapParams kalman;
  kalman.mahalanobisDistanceThreshold = std::numeric_limits<double>::infinity();
  compareWithSlowOne(0.1, kalman);
}

TEST(ElevationOracle, FusionIsThatOfTheSlowOne)
{
  std::mt19937 random(11);
  ElevationMap map(0.01);
  for (int i = 0; i < 3; ++i)
  {
    const RandomScan scan(random);
    map.insert(scan.scan(), {});
    const auto& fused = map.fuse();
    const auto heights = map.height(), variances = map.variance();
    ASSERT_EQ(fused.height.frame(), heights.frame());
    for (std::int32_t iy = 0; iy < heights.frame().height; ++iy)
      for (std::int32_t ix = 0; ix < heights.frame().width; ++ix)
      {
        ASSERT_EQ(std::isnan(fused.height.at(ix, iy)), std::isnan(heights.at(ix, iy)));
        if (std::isnan(heights.at(ix, iy))) continue;
        const oracle::SlowFusion slow(heights, variances, ix, iy);
        ASSERT_NEAR(fused.height.at(ix, iy), slow.mean(), 1e-5);
        ASSERT_NEAR(fused.lower.at(ix, iy), slow.lower(), 1e-5);
        ASSERT_NEAR(fused.upper.at(ix, iy), slow.upper(), 1e-5);
      }
  }
}
