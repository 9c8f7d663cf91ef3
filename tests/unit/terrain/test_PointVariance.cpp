// The variance of a point's height: σ_h² = J_S Σ_S J_Sᵀ + J_P Σ_P J_Pᵀ.
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <cmath>

#include "../oracle/TerrainCells.h"
#include "HandTerrain.h"

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
  EXPECT_NEAR(variance(point(0, 0, -2), only(0.1, 0), zeros()), 0.01, 1e-6);
  EXPECT_NEAR(variance(point(2, 0, 0), only(0.1, 0), zeros()), 1e-6, 1e-9);  // the least
  EXPECT_NEAR(variance(point(0, 4, -3), only(0.1, 0), zeros()), 0.01 * 9 / 25, 1e-6);
}

TEST(PointVariance, OfTheBeamGrowsWithTheDistanceAcross)
{
  EXPECT_NEAR(variance(point(0, 0, -2), only(0, 0.01), zeros()), 1e-6, 1e-9);
  EXPECT_NEAR(variance(point(20, 0, 0), only(0, 0.01), zeros()), 0.04, 1e-6);
  EXPECT_NEAR(variance(point(0, 40, -30), only(0, 0.01), zeros()), 0.16, 1e-5);
}

/** Robot level in the origin: z by roll is y, by pitch −x. */
TEST(PointVariance, OfThePoseByHand)
{
  auto covariance = zeros();
  covariance(0, 0) = 0.04;
  EXPECT_NEAR(variance(point(3, 4, 0), only(0, 0), covariance), 0.04, 1e-6);
  covariance = zeros();
  covariance(1, 1) = 0.01;
  EXPECT_NEAR(variance(point(3, 4, 0), only(0, 0), covariance), 0.16, 1e-6);
  covariance = zeros();
  covariance(2, 2) = 0.01;
  EXPECT_NEAR(variance(point(3, 4, 0), only(0, 0), covariance), 0.09, 1e-6);
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
  EXPECT_NEAR(variance(point(3, 4, 0), only(0, 0), covariance), wanted, 1e-5);
}

/** The robot, not the sensor, rolls and pitches: a sensor 10 m ahead of it moves up and down. */
TEST(PointVariance, RollAndPitchAreTheRobots)
{
  auto covariance = zeros();
  covariance(2, 2) = 0.01;
  HandScan hand = point(0, 0, -1);
  hand.robotPose = CPose3D(100, 50, 1, 0.7, 0, 0);
  hand.sensorPose = hand.robotPose + CPose3D(10, 0, 0, 0, 0, 0);
  EXPECT_NEAR(variance(hand, only(0, 0), covariance), 1, 1e-4);
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
        EXPECT_NEAR(variance(hand, sigmas, covariance), wanted, 1e-4 * wanted);
      }
}

TEST(PointVariance, OfANearPointIsThatOf1mm)
{
  EXPECT_NEAR(variance(point(0, 0, 0), only(0.02, 0.001), zeros()), 1e-6, 1e-9);
  EXPECT_NEAR(variance(point(0, 0, 1), only(1e-5, 0), zeros()), 1e-6, 1e-9);
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
