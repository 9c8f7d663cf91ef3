#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/GroundScore.h>

#include <cmath>
#include <stdexcept>

using namespace mrpt_mapconv::eval;

TEST(GroundScore, CountsWhatIsMissedAndWhatIsTakenForGround)
{
  const auto score = scoreGround({2, 1, 2, 1, 1, 1}, {2, 2, 1, 1, 6, 0});
  EXPECT_EQ(score.groundAsGround, 1U);
  EXPECT_EQ(score.groundAsOther, 1U);
  EXPECT_EQ(score.otherAsGround, 1U);
  EXPECT_EQ(score.otherAsOther, 3U);
  EXPECT_DOUBLE_EQ(score.typeI(), 0.5);
  EXPECT_DOUBLE_EQ(score.typeII(), 0.25);
  EXPECT_DOUBLE_EQ(score.total(), 2.0 / 6);
}

TEST(GroundScore, KappaIsThatOfAWorkedExample)
{
  // 20 + 15 of 50 agree; by chance 0.5·0.6 + 0.5·0.4 would (Wikipedia's example of Cohen's kappa)
  const GroundScore score{20, 5, 10, 15};
  EXPECT_NEAR(score.kappa(), 0.4, 1e-12);
}

TEST(GroundScore, KappaIsZeroForAFilterThatTakesAllForGround)
{
  const GroundScore score{30, 0, 70, 0};
  EXPECT_NEAR(score.kappa(), 0, 1e-12);
}

TEST(GroundScore, OfNothingThereIsNoScore)
{
  const GroundScore none;
  EXPECT_TRUE(std::isnan(none.typeI()));
  EXPECT_TRUE(std::isnan(none.typeII()));
  EXPECT_TRUE(std::isnan(none.total()));
  EXPECT_TRUE(std::isnan(none.kappa()));
  EXPECT_TRUE(std::isnan((GroundScore{5, 0, 0, 0}.kappa())));
}

TEST(GroundScore, RefusesClassesOfOtherPoints)
{
  EXPECT_THROW(scoreGround({1, 2}, {1}), std::invalid_argument);
}
