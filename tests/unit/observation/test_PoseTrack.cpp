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
  expectPose(track.at(at(1.5)), pose(2, 3, 4, 22.5, 0, 0));
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
