#include <gtest/gtest.h>
#include <mrpt_mapconv/observation/FarPoses.h>

#include <vector>

using namespace mrpt_mapconv;
using observation::PosedObservation;

namespace
{
std::vector<PosedObservation> at(std::vector<mrpt::poses::CPose3D> poses)
{
  std::vector<PosedObservation> scans;
  for (const auto& pose : poses) scans.push_back({nullptr, pose});
  return scans;
}
}  // namespace

TEST(FarPoses, NearOnesStayWhereTheyAre)
{
  const auto scans = at({{1600, -1600, 3000, 0, 0, 0}, {0, 0, 0, 0, 0, 0}});
  EXPECT_EQ(observation::originOf(scans, 0.1), mrpt::math::TPoint3D(0, 0, 0));
  EXPECT_EQ(observation::originOf(scans, 0), mrpt::math::TPoint3D(0, 0, 0));
  EXPECT_EQ(observation::originOf({}, 0.1), mrpt::math::TPoint3D(0, 0, 0));
}

TEST(FarPoses, FarOnesAreMovedByWholeMetres)
{
  auto scans = at({{448258.4, 5411929.6, 210, 1, 0, 0}, {448260, 5411930, 211, 0, 0, 0}});
  const auto origin = observation::originOf(scans, 0.1);
  EXPECT_EQ(origin, mrpt::math::TPoint3D(448258, 5411930, 0));
  observation::moveToOrigin(scans, origin);
  EXPECT_NEAR(scans[0].robotPose.x(), 0.4, 1e-6);
  EXPECT_NEAR(scans[0].robotPose.y(), -0.4, 1e-6);
  EXPECT_EQ(scans[0].robotPose.z(), 210);
  EXPECT_EQ(scans[0].robotPose.yaw(), 1);
  EXPECT_EQ(scans[1].robotPose.x(), 2);
}

TEST(FarPoses, WhatAnOctreeReachesCounts)
{
  const auto scans = at({{200, 0, 0, 0, 0, 0}});
  EXPECT_EQ(observation::originOf(scans, 0.01).x, 200);  // half of its reach are 163.84 m
  EXPECT_EQ(observation::originOf(scans, 0.02).x, 0);
  EXPECT_EQ(observation::originOf(at({{0, -10001, 0, 0, 0, 0}}), 0).y, -10001);
}
