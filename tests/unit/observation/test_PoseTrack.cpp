#include <mrpt_mapconv/observation/PoseTrack.h>

#include <limits>

#include "support/ScanFixtures.h"

namespace mrpt_mapconv::observation
{
using mrpt::poses::CPose3D;

namespace
{
mrpt::system::TTimeStamp at(double seconds) { return mrpt::Clock::fromDouble(1e9 + seconds); }
CPose3D pose(double x, double y, double z, double yaw, double pitch, double roll)
{
  return {x, y, z, mrpt::DEG2RAD(yaw), mrpt::DEG2RAD(pitch), mrpt::DEG2RAD(roll)};
}
void expectPose(const std::optional<CPose3D>& got, const CPose3D& expected)
{
  ASSERT_TRUE(got);
  EXPECT_LT((got->getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>() -
             expected.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>())
                .sum_abs(),
            1e-6)
      << *got << " instead of " << expected;
}
}  // namespace

TEST(PoseTrack, MovesInAStraightLineAndTurnsEvenly)
{
  PoseTrack track;
  EXPECT_TRUE(track.insert(at(3), pose(5, 6, 7, 90, 0, 0)));
  EXPECT_TRUE(track.insert(at(1), pose(1, 2, 3, 0, 0, 0)));
  EXPECT_EQ(track.size(), 2u);
  expectPose(track.at(at(1)), pose(1, 2, 3, 0, 0, 0));
  expectPose(track.at(at(3)), pose(5, 6, 7, 90, 0, 0));
  expectPose(track.at(at(1.5), 2), pose(2, 3, 4, 22.5, 0, 0));
  expectPose(track.at(at(2)), pose(3, 4, 5, 45, 0, 0));
}

TEST(PoseTrack, TurnsTheShortWay)
{
  PoseTrack track;
  track.insert(at(0), pose(0, 0, 0, 170, 0, 0));
  track.insert(at(1), pose(0, 0, 0, -170, 0, 0));
  expectPose(track.at(at(0.5)), pose(0, 0, 0, 180, 0, 0));
}

TEST(PoseTrack, TurnsAboutOneAxisAndNotThreeAngles)
{
  // From the identity to a third of a turn about (1, 1, 1), which is yaw and roll 90° in MRPT's
  // angles; half of it maps x to (2, 2, −1)/3.
  PoseTrack track;
  track.insert(at(0), CPose3D());
  track.insert(at(1), pose(0, 0, 0, 90, 0, 90));
  const auto half = track.at(at(0.5));
  ASSERT_TRUE(half);
  const auto x = half->composePoint(mrpt::math::TPoint3D(1, 0, 0));
  EXPECT_LT((x - mrpt::math::TPoint3D(2, 2, -1) * (1.0 / 3)).norm(), 1e-6) << x;
}

TEST(PoseTrack, HoldsItsEndsForATenthOfASecond)
{
  PoseTrack track;
  EXPECT_FALSE(track.at(at(0)));
  track.insert(at(0), pose(1, 0, 0, 0, 0, 0));
  track.insert(at(1), pose(2, 0, 0, 0, 0, 0));
  expectPose(track.at(at(-0.09)), pose(1, 0, 0, 0, 0, 0));
  expectPose(track.at(at(1.09)), pose(2, 0, 0, 0, 0, 0));
  EXPECT_FALSE(track.at(at(-0.11)));
  EXPECT_FALSE(track.at(at(1.11)));
  EXPECT_FALSE(track.at(INVALID_TIMESTAMP));
}

TEST(PoseTrack, KnowsNothingInAGap)
{
  using Coverage = PoseTrack::Coverage;
  PoseTrack track;
  track.insert(at(0), pose(1, 0, 0, 0, 0, 0));
  track.insert(at(2), pose(3, 0, 0, 0, 0, 0));
  track.insert(at(62), pose(9, 0, 0, 0, 0, 0));
  expectPose(track.at(at(1)), pose(2, 0, 0, 0, 0, 0));
  EXPECT_FALSE(track.at(at(0.9))) << "1.1 s before a pose";
  EXPECT_FALSE(track.at(at(1.1))) << "1.1 s after one";
  EXPECT_FALSE(track.at(at(2.5))) << "near one of both only";
  EXPECT_TRUE(track.at(at(2))) << "at a pose";
  EXPECT_TRUE(track.at(at(2.5), 60));
  EXPECT_EQ(Coverage::Gap, track.coverage(at(30)));
  EXPECT_EQ(Coverage::Outside, track.coverage(at(63)));
  EXPECT_EQ(Coverage::Outside, track.coverage(at(-1)));
  EXPECT_EQ(Coverage::NoTime, track.coverage(INVALID_TIMESTAMP));
  EXPECT_EQ(Coverage::Known, track.coverage(at(62.05)));
  EXPECT_EQ(Coverage::Outside, PoseTrack().coverage(at(0)));
  EXPECT_NEAR(60, track.gapAt(at(30)), 1e-6);
  EXPECT_EQ(0, track.gapAt(at(90)));
}

TEST(PoseTrack, RefusesWhatIsNoPose)
{
  PoseTrack track;
  EXPECT_FALSE(track.insert(INVALID_TIMESTAMP, CPose3D()));
  EXPECT_FALSE(
      track.insert(at(0), CPose3D(std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 0, 0)));
  EXPECT_FALSE(track.insert(at(0), CPose3D(0, 0, std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(track.empty());
}

}  // namespace mrpt_mapconv::observation
