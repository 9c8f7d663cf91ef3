// The variance of a point's height: σ_h² = J_S Σ_S J_Sᵀ + J_P Σ_P J_Pᵀ.
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <cmath>

#include "HandTerrain.h"
#include "oracle/TerrainCells.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using mrpt::poses::CPose3D;

/** What a map says of one point that it got. */
double variance(const HandScan& hand, const terrain::PointSigmas& sigmas,
                const mrpt::math::CMatrixDouble33& covariance)
{
  terrain::TerrainMap map(1000);
  auto scan = hand.scan();
  scan.poseCovariance = covariance;
  map.insert(scan, sigmas);
  EXPECT_EQ(map.cells(), 1u);
  const auto at = hand.sensorPose.composePoint(
      mrpt::math::TPoint3D(static_cast<double>(hand.x[0]), static_cast<double>(hand.y[0]),
                           static_cast<double>(hand.z[0])));
  return map.cell(map.keyOf(at.x), map.keyOf(at.y))->variance;
}

/** Cells keep 1/σ² in whole sixteenths of 1/m², and points are computed in floats. */
void expectVariance(double found, double wanted)
{
  EXPECT_NEAR(1 / found, 1 / wanted, 0.5 / 16 + 1e-5 / wanted) << found << ", not " << wanted;
}

mrpt::math::CMatrixDouble33 zeros()
{
  mrpt::math::CMatrixDouble33 covariance;
  covariance.setZero();
  return covariance;
}

terrain::PointSigmas only(double range, double beam)
{
  terrain::PointSigmas sigmas;
  sigmas.range = range;
  sigmas.beam = beam;
  return sigmas;
}

HandScan point(double x, double y, double z)
{
  HandScan hand;
  hand.add(x, y, z);
  return hand;
}
}  // namespace

TEST(PointVariance, OfTheRangeGrowsWithTheBeamsSlope)
{
  // straight down; level; 3-4-5
  expectVariance(variance(point(0, 0, -2), only(0.1, 0), zeros()), 0.01);
  expectVariance(variance(point(2, 0, 0), only(0.1, 0), zeros()), 1e-6);  // the least
  expectVariance(variance(point(0, 4, -3), only(0.1, 0), zeros()), 0.01 * 9 / 25);
}

TEST(PointVariance, OfTheBeamGrowsWithTheDistanceAcross)
{
  expectVariance(variance(point(0, 0, -2), only(0, 0.01), zeros()), 1e-6);
  expectVariance(variance(point(20, 0, 0), only(0, 0.01), zeros()), 0.04);
  expectVariance(variance(point(0, 40, -30), only(0, 0.01), zeros()), 0.16);
}

/** Robot level in the origin: z by roll is y, by pitch −x. */
TEST(PointVariance, OfThePoseByHand)
{
  auto covariance = zeros();
  covariance(0, 0) = 0.04;
  expectVariance(variance(point(3, 4, 0), only(0, 0), covariance), 0.04);
  covariance = zeros();
  covariance(1, 1) = 0.01;
  expectVariance(variance(point(3, 4, 0), only(0, 0), covariance), 0.16);
  covariance = zeros();
  covariance(2, 2) = 0.01;
  expectVariance(variance(point(3, 4, 0), only(0, 0), covariance), 0.09);
}

TEST(PointVariance, HoldsCorrelations)
{
  auto covariance = zeros();
  covariance(0, 0) = 0.04;
  covariance(1, 1) = 0.01;
  covariance(2, 2) = 0.02;
  covariance(0, 1) = covariance(1, 0) = 0.005;
  covariance(0, 2) = covariance(2, 0) = -0.003;
  covariance(1, 2) = covariance(2, 1) = 0.002;
  // J = (1, 4, −3)
  const double wanted = 0.04 + 16 * 0.01 + 9 * 0.02 + 2 * (4 * 0.005 + 3 * 0.003 - 12 * 0.002);
  expectVariance(variance(point(3, 4, 0), only(0, 0), covariance), wanted);
}

/** The robot, not the sensor, rolls and pitches: a sensor 10 m ahead of it moves up and down. */
TEST(PointVariance, RollAndPitchAreTheRobots)
{
  auto covariance = zeros();
  covariance(2, 2) = 0.01;
  HandScan hand = point(0, 0, -1);
  hand.robotPose = CPose3D(100, 50, 1, 0.7, 0, 0);
  hand.sensorPose = hand.robotPose + CPose3D(10, 0, 0, 0, 0, 0);
  expectVariance(variance(hand, only(0, 0), covariance), 1);
}

TEST(PointVariance, IsThatOfFiniteDifferences)
{
  auto covariance = zeros();
  covariance(0, 0) = 1e-4;
  covariance(1, 1) = 4e-4;
  covariance(2, 2) = 9e-4;
  covariance(0, 1) = covariance(1, 0) = 1e-4;
  covariance(1, 2) = covariance(2, 1) = -3e-4;
  for (const double yaw : {0.0, 2.5})
    for (const double pitch : {0.0, -0.4, 1.2})
      for (const double roll : {0.0, 0.9, -2.8})
      {
        HandScan hand = point(1.5, -4, 0.7);
        hand.robotPose = CPose3D(20, -30, 2, yaw, pitch, roll);
        hand.sensorPose = hand.robotPose + CPose3D(0.3, 0.2, 0.5, -0.6, 0.8, 0.1);
        auto scan = hand.scan();
        scan.poseCovariance = covariance;
        const auto sigmas = only(0.02, 0.003);
        const double wanted = oracle::heightVariance(scan, 0, sigmas);
        expectVariance(variance(hand, sigmas, covariance), wanted);
      }
}

TEST(PointVariance, OfANearPointIsThatOf1mm)
{
  expectVariance(variance(point(0, 0, 0), only(0.02, 0.001), zeros()), 1e-6);
  expectVariance(variance(point(0, 0, 1), only(1e-5, 0), zeros()), 1e-6);
}

TEST(PointVariance, OfTheCellIsThatOfItsFusedPoints)
{
  terrain::TerrainMap map(kCell);
  map.insertPoint(0, 0, 1, 0.1);
  map.insertPoint(0, 0, 2, 0.05);
  // weights 100 and 400
  EXPECT_NEAR(map.cell(0, 0)->height, 1.8, 1e-4);
  EXPECT_NEAR(map.cell(0, 0)->variance, 1.0 / 500, 1e-6);
  terrain::TerrainParams params;
  params.heightRule = terrain::HeightRule::Maximum;
  terrain::TerrainMap highest(kCell, params);
  highest.insertPoint(0, 0, 1, 0.05);
  highest.insertPoint(0, 0, 2, 0.1);
  EXPECT_NEAR(highest.cell(0, 0)->height, 2, 1e-4);
  EXPECT_NEAR(highest.cell(0, 0)->variance, 0.01, 1e-5);
}
