// How sure logs are of the robot's height, roll and pitch.
#include <limits>

#include "LogObjects.h"

namespace mrpt_mapconv::observation
{
namespace
{
/** In MRPT's order: x, y, z, yaw, pitch, roll. */
mrpt::math::CMatrixDouble66 covarianceOf(double z, double pitch, double roll)
{
  mrpt::math::CMatrixDouble66 out;
  out(0, 0) = out(1, 1) = 7;
  out(3, 3) = 8;
  out(2, 2) = z;
  out(4, 4) = pitch;
  out(5, 5) = roll;
  return out;
}

CObservation::Ptr surePoseAt(double seconds, const CPose3D& pose,
                             const mrpt::math::CMatrixDouble66& covariance,
                             const CPose3D& sensor = {})
{
  auto obs = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(poseAt(seconds, pose));
  obs->pose.cov = covariance;
  obs->sensorPose = sensor;
  return obs;
}

void expectDiagonal(const std::optional<HeightCovariance>& covariance, double z, double roll,
                    double pitch)
{
  ASSERT_TRUE(covariance);
  EXPECT_NEAR((*covariance)(0, 0), z, 1e-9);
  EXPECT_NEAR((*covariance)(1, 1), roll, 1e-9);
  EXPECT_NEAR((*covariance)(2, 2), pitch, 1e-9);
}
}  // namespace

TEST(PoseCovariance, IsThatOfHeightRollAndPitch)
{
  auto whole = covarianceOf(1, 3, 2);
  whole(2, 4) = whole(4, 2) = 0.5;
  whole(2, 5) = whole(5, 2) = 0.25;
  const auto part = heightCovariance(whole);
  expectDiagonal(part, 1, 2, 3);
  EXPECT_EQ((*part)(0, 2), 0.5);
  EXPECT_EQ((*part)(1, 0), 0.25);
  EXPECT_EQ((*part)(1, 2), 0);
}

TEST(PoseCovariance, IsUnknownWhereAllIsZeroOrNoVariance)
{
  EXPECT_FALSE(heightCovariance(covarianceOf(0, 0, 0)));
  EXPECT_FALSE(heightCovariance(covarianceOf(1, -1, 0)));
  EXPECT_FALSE(heightCovariance(covarianceOf(std::nan(""), 1, 1)));
  EXPECT_TRUE(heightCovariance(covarianceOf(0, 0, 1e-12)));
}

TEST(PoseCovariance, ComesFromTheKeyframesOfASimpleMap)
{
  const TempDir dir;
  mrpt::maps::CSimpleMap map;
  for (const double variance : {0.0, 0.25})
  {
    mrpt::poses::CPose3DPDFGaussian pose;
    pose.cov = covarianceOf(variance, variance, variance);
    map.insert(pose, *frame({cloudAt(0)}));
  }
  ASSERT_TRUE(map.saveToFile(dir.file("a.simplemap")));
  const auto scans = readSimpleMap(dir.file("a.simplemap"));
  ASSERT_EQ(scans.size(), 2u);
  EXPECT_FALSE(scans[0].poseCovariance);
  expectDiagonal(scans[1].poseCovariance, 0.25, 0.25, 0.25);
}

TEST(PoseCovariance, OfARawlogIsLinearBetweenItsPoses)
{
  const TempDir dir;
  const auto path =
      rawlog(dir, {surePoseAt(0, {}, covarianceOf(1, 2, 3)), cloudAt(0), cloudAt(0.25),
                   surePoseAt(1, {}, covarianceOf(5, 6, 7)), cloudAt(1.05)});
  const auto scans = readRawlog(path);
  ASSERT_EQ(scans.size(), 3u);
  expectDiagonal(scans[0].poseCovariance, 1, 3, 2);
  expectDiagonal(scans[1].poseCovariance, 2, 4, 3);
  expectDiagonal(scans[2].poseCovariance, 5, 7, 6);
}

TEST(PoseCovariance, OfARawlogIsUnknownBesideAPoseThatHasNone)
{
  const TempDir dir;
  const auto path = rawlog(dir, {surePoseAt(0, {}, covarianceOf(1, 2, 3)), cloudAt(0), cloudAt(0.5),
                                 poseAt(1, {}), cloudAt(1)});
  const auto scans = readRawlog(path);
  ASSERT_EQ(scans.size(), 3u);
  EXPECT_TRUE(scans[0].poseCovariance);
  EXPECT_FALSE(scans[1].poseCovariance);
  EXPECT_FALSE(scans[2].poseCovariance);
  RawlogOptions standing;
  standing.staticSensor = true;
  EXPECT_FALSE(readRawlog(path, standing).at(0).poseCovariance);
}

TEST(PoseCovariance, OdometryHasNone)
{
  const TempDir dir;
  const auto scans = readRawlog(rawlog(dir, {odometryAt(0, 1, 0, 0), cloudAt(0)}));
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_FALSE(scans[0].poseCovariance);
}

/** The sensor whose pose was observed is 1 m ahead of the robot, which is as much higher as the
 * sensor is pitched down. */
TEST(PoseCovariance, IsTheRobotsAndNotTheObservedSensors)
{
  const TempDir dir;
  const auto path = rawlog(
      dir, {surePoseAt(0, {}, covarianceOf(0.01, 0.04, 0.09), {1, 0, 0, 0, 0, 0}), cloudAt(0)});
  const auto scans = readRawlog(path);
  ASSERT_EQ(scans.size(), 1u);
  ASSERT_TRUE(scans[0].poseCovariance);
  const auto& covariance = *scans[0].poseCovariance;
  EXPECT_NEAR(covariance(0, 0), 0.01 + 0.04, 1e-6);
  EXPECT_NEAR(covariance(0, 2), 0.04, 1e-6);
  EXPECT_NEAR(covariance(1, 1), 0.09, 1e-6);
  EXPECT_NEAR(covariance(2, 2), 0.04, 1e-6);
}

}  // namespace mrpt_mapconv::observation
