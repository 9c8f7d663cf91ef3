#include <gtest/gtest.h>
#include <mrpt_mapconv/aerial/Ground.h>
#include <mrpt_mapconv/eval/GroundScore.h>

#include <random>
#include <stdexcept>
#include <string>

#include "HandCloud.h"
#include "support/ThrownMessage.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using aerial::GroundFilter;
using aerial::GroundParams;

class GroundOf : public testing::TestWithParam<GroundFilter>
{
 protected:
  GroundParams params() const
  {
    GroundParams p;
    p.groundFilter = GetParam();
    return p;
  }
  eval::GroundScore score(const HandCloud& hand) const
  {
    return eval::scoreGround(aerial::findGround(hand.cloud, params()).classification, hand.truth);
  }
};

HandCloud onSlope(double slope)
{
  HandCloud hand;
  addGround(hand, 60, 0.5, [&](double x, double y) { return slope * (x + 0.3 * y); });
  return hand;
}
}  // namespace

INSTANTIATE_TEST_SUITE_P(Filters, GroundOf, testing::Values(GroundFilter::Csf, GroundFilter::Smrf),
                         [](const auto& test) { return params::textOf(test.param); });

TEST_P(GroundOf, LevelGroundIsAllGround) { EXPECT_EQ(score(onSlope(0)).groundAsOther, 0U); }

TEST_P(GroundOf, ASlopeIsGround)
{
  for (const double slope : {0.1, 0.3}) EXPECT_LT(score(onSlope(slope)).typeI(), 0.01) << slope;
}

TEST_P(GroundOf, AHouseIsNoGround)
{
  for (const double slope : {0.0, 0.1})
  {
    HandCloud hand = onSlope(slope);
    addBox(hand, 20, 35, 22, 33, 6);
    EXPECT_LT(score(hand).typeI(), 0.01) << slope;
    EXPECT_EQ(score(hand).otherAsGround, 0U) << slope;
  }
}

TEST_P(GroundOf, BothSidesOfALowStepAreGround)
{
  HandCloud hand;
  addGround(hand, 60, 0.5, [](double x, double) { return x < 30 ? 0 : 1; });
  EXPECT_LT(score(hand).typeI(), 0.01);
}

TEST_P(GroundOf, LeavesOverFewGroundPointsAreNoGround)
{
  std::mt19937 random(1);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  HandCloud hand;
  for (int i = 0; i < 60000; ++i)
  {
    const double x = 40 * share(), y = 40 * share(), z = 0.3 * x;
    const bool isGround = share() < 0.02;
    hand.add(x, y, isGround ? z : z + 8 + 8 * share(), isGround);
  }
  // smrf takes ground at the upper end for an object, see morphologicalGround()
  EXPECT_LT(score(hand).typeI(), GetParam() == GroundFilter::Csf ? 0.01 : 0.1);
  EXPECT_EQ(score(hand).otherAsGround, 0U);
}

TEST_P(GroundOf, LowPointsDoNotPullTheGroundDown)
{
  std::mt19937 random(2);
  HandCloud hand;
  addGround(hand, 80, 0.25, [](double x, double) { return 0.3 * x; });
  for (std::size_t i = 0; i < hand.cloud.size(); ++i)
  {
    if (random() % 1000 != 0) continue;
    hand.cloud.z[i] -= 1 + static_cast<double>(random() % 2900) / 100;
    hand.truth[i] = cloud::kUnclassified;
  }
  const auto ground = aerial::findGround(hand.cloud, params());
  const auto score = eval::scoreGround(ground.classification, hand.truth);
  EXPECT_LT(score.typeI(), 0.01);
  EXPECT_LT(score.typeII(), 0.1);
  EXPECT_GT(ground.lowPoints, 80U);
}

TEST_P(GroundOf, DegenerateCloudsAreGround)
{
  HandCloud one;
  one.add(3, 4, 5, true);
  EXPECT_EQ(aerial::findGround(one.cloud, params()).groundPoints, 1U);
  HandCloud line;
  for (int i = 0; i < 50; ++i) line.add(0.3 * i, 7, 0.03 * i, true);
  EXPECT_EQ(aerial::findGround(line.cloud, params()).groundPoints, 50U);
  HandCloud pile;
  for (int i = 0; i < 5; ++i) pile.add(1, 1, 2, true);
  EXPECT_EQ(aerial::findGround(pile.cloud, params()).groundPoints, 5U);
}

TEST_P(GroundOf, WithheldPointsTakeNoPart)
{
  HandCloud hand = onSlope(0);
  hand.cloud.withheld.assign(hand.cloud.size(), 0);
  hand.add(30.1, 30.1, 0, false);
  hand.cloud.withheld.push_back(1);
  const auto ground = aerial::findGround(hand.cloud, params());
  EXPECT_EQ(ground.classification.back(), cloud::kUnclassified);
  EXPECT_EQ(ground.unusedPoints, 1U);
  EXPECT_EQ(ground.groundPoints, hand.cloud.size() - 1);
}

TEST_P(GroundOf, ACloudTooWideIsRefusedBeforeAnythingIsMade)
{
  HandCloud hand;
  hand.add(0, 0, 0, true);
  hand.add(5e6, 5e6, 0, true);
  const auto message =
      thrownMessage<std::runtime_error>([&] { aerial::findGround(hand.cloud, params()); });
  EXPECT_NE(message.find("5e+06 x 5e+06 m"), std::string::npos) << message;
  EXPECT_NE(message.find("cellSize = 0.25 m"), std::string::npos) << message;
  hand.cloud.x[1] = 1e300;
  EXPECT_THROW(aerial::findGround(hand.cloud, params()), std::runtime_error);
}

TEST(Ground, AnEmptyCloudHasNone) { EXPECT_THROW(aerial::findGround({}, {}), std::runtime_error); }

TEST(Ground, ParametersAreChecked)
{
  GroundParams params;
  params.rigidness = 0;
  HandCloud hand = onSlope(0);
  EXPECT_THROW(aerial::findGround(hand.cloud, params), std::invalid_argument);
}

TEST(Ground, OpeningsFindHousesAsWideAsTheWindow)
{
  HandCloud hand;
  addGround(hand, 100, 0.5, [](double, double) { return 0; });
  addBox(hand, 30, 66, 30, 66, 6);  // 36 cells: too few for a disc of 18, enough for one of 17
  GroundParams params;
  params.groundFilter = GroundFilter::Smrf;
  const auto found = [&]
  {
    return eval::scoreGround(aerial::findGround(hand.cloud, params).classification, hand.truth)
        .otherAsGround;
  };
  EXPECT_EQ(found(), 0U);
  params.smrfWindow = 17;
  EXPECT_GT(found(), 1000U);
}

TEST(Ground, TheClothLiesOnSteepHillsides)
{
  for (const double slope : {0.6, 1.0})
    EXPECT_LT(eval::scoreGround(aerial::findGround(onSlope(slope).cloud, {}).classification,
                                onSlope(slope).truth)
                  .typeI(),
              0.01)
        << slope;
}

TEST(Ground, HeightScaleMakesUpForCellsWhoseLowestPointIsLow)
{
  HandCloud hand;  // a hundred points a cell
  addGround(hand, 20, 0.05, [](double x, double) { return x; });
  GroundParams params;
  const auto missed = [&]
  {
    return eval::scoreGround(aerial::findGround(hand.cloud, params).classification, hand.truth)
        .typeI();
  };
  EXPECT_LT(missed(), 0.01);
  params.heightScale = 0;
  EXPECT_GT(missed(), 0.3);
}

TEST(Ground, TheClothReachesSteepHillsOnlyWithSlopeSmoothing)
{
  HandCloud hand;
  addGround(hand, 60, 0.5,
            [](double x, double y) { return 0.4 * x + 2.5 * std::sin(x / 5) * std::cos(y / 6); });
  GroundParams params;
  const auto missed = [&]
  {
    return eval::scoreGround(aerial::findGround(hand.cloud, params).classification, hand.truth)
        .typeI();
  };
  EXPECT_LT(missed(), 0.02);
  params.slopeSmoothing = false;
  EXPECT_GT(missed(), 0.1);
}
