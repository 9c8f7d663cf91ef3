#include <gtest/gtest.h>
#include <mrpt_mapconv/aerial/Ground.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "../mrpt_mapconv/src/aerial/LowPoints.h"
#include "HandCloud.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;

aerial::UsedPoints usedAfter(const HandCloud& hand, const aerial::GroundParams& params = {})
{
  auto used = aerial::usablePoints(hand.cloud);
  aerial::leaveOutLowPoints(hand.cloud, params, 1, used);
  return used;
}

HandCloud slope()
{
  HandCloud hand;
  addGround(hand, 30, 0.5, [](double x, double) { return 0.7 * x; });
  return hand;
}
}  // namespace

TEST(LowPoints, APointFarBelowTheOthersIsLeftOut)
{
  HandCloud hand = slope();
  const std::size_t low = hand.cloud.size();
  hand.add(15.1, 15.1, -20, false);
  const auto used = usedAfter(hand);
  EXPECT_EQ(used[low], 0);
  for (std::size_t i = 0; i < low; ++i) EXPECT_EQ(used[i], 1) << i;
}

TEST(LowPoints, AlsoOneAboveAnother)
{
  HandCloud hand = slope();
  hand.add(15.1, 15.1, -20, false);
  hand.add(15.2, 15.1, -10, false);
  const auto used = usedAfter(hand);
  EXPECT_EQ(used[used.size() - 1], 0);
  EXPECT_EQ(used[used.size() - 2], 0);
}

TEST(LowPoints, AHollowWithManyPointsIsGround)
{
  HandCloud hand = slope();
  for (int i = 0; i < 30; ++i) hand.add(15 + 0.02 * i, 15.1, -2, true);
  for (const auto used : usedAfter(hand)) EXPECT_EQ(used, 1);
}

TEST(LowPoints, RadiusZeroLeavesNoneOut)
{
  HandCloud hand = slope();
  hand.add(15.1, 15.1, -20, false);
  aerial::GroundParams params;
  params.lowPointRadius = 0;
  EXPECT_EQ(usedAfter(hand, params).back(), 1);
}

TEST(LowPoints, TwoPointsAreNotJudged)
{
  HandCloud hand;
  addGround(hand, 30, 0.5, [](double, double) { return 0; });
  hand.add(200, 0, 0, true);
  hand.add(201, 0, 50, true);
  const auto used = usedAfter(hand);
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
}

TEST(LowPoints, SomeAreAlwaysLeft)
{
  HandCloud hand;
  for (const double z : {0, 50, 100}) hand.add(0, 0, z, true);
  EXPECT_EQ(usedAfter(hand), (aerial::UsedPoints{1, 1, 1}));
}

TEST(LowPoints, AreFoundOnAHillsideAmongItsOwnLowerPoints)
{
  HandCloud hand;
  addGround(hand, 40, 0.25, [](double x, double) { return 0.7 * x; });
  hand.add(20.1, 20.1, 0.7 * 20.1 - 2, false);
  EXPECT_EQ(usedAfter(hand).back(), 0);
}

TEST(LowPoints, FewGroundReturnsUnderACrownAreNotAmongThem)
{
  HandCloud hand;
  addGround(hand, 30, 0.15, [](double, double) { return 15; });
  for (int i = 0; i < 300; ++i) hand.add(0.1 * i, 0.1 * ((37 * i) % 300), 0, true);
  const auto used = usedAfter(hand);
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
}

/** Level ground of random points, one in a thousand of them up to 30 m too low. */
HandCloud surveyOf(double density, double side, unsigned seed)
{
  std::mt19937 random(seed);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  HandCloud hand;
  for (int i = 0; i < static_cast<int>(density * side * side); ++i)
  {
    const bool isLow = i % 1000 == 0;
    hand.add(side * share(), side * share(), isLow ? -1 - 29 * share() : 0.1 * share(), !isLow);
  }
  return hand;
}

TEST(LowPoints, OneInAThousandMakesNoPitAtAnyDensity)
{
  for (const double density : {0.5, 2.0, 4.0, 20.0, 70.0})
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
      const HandCloud hand = surveyOf(density, density < 10 ? 100 : 40, seed);
      const auto ground = aerial::findGround(hand.cloud, {}, 1);
      const auto& heights = ground.layers.ground.cells();
      EXPECT_GT(*std::min_element(heights.begin(), heights.end()), -1)
          << "density " << density << ", seed " << seed;
    }
}

TEST(LowPoints, AStrayPointChangesNothingElsewhere)
{
  HandCloud hand;
  addGround(hand, 100, 1, [](double x, double) { return 15 * std::sin(x / 30); });
  const auto before = usedAfter(hand);
  hand.add(800, 900, 0, true);
  auto after = usedAfter(hand);
  after.pop_back();
  EXPECT_EQ(after, before);
  EXPECT_NEAR(aerial::meanDistance(hand.cloud, usedAfter(hand)), 1, 0.3);
}

TEST(LowPoints, OfASparseCloudAreJudgedByWhatIsFarther)
{
  HandCloud hand;
  addGround(hand, 600, 12, [](double, double) { return 0; });
  const std::size_t low = hand.cloud.size();
  hand.add(301, 301, -20, false);
  const auto used = usedAfter(hand);
  EXPECT_EQ(used[low], 0);
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 1);
}

TEST(UsablePoints, NoiseIsNotAmongThemAndKeepsItsClass)
{
  HandCloud hand = slope();
  hand.cloud.classification.assign(hand.cloud.size(), 1);
  for (const std::uint8_t noise : std::vector<std::uint8_t>{7, 18})
  {
    hand.add(15.1, 15.1, 2, false);
    hand.cloud.classification.push_back(noise);
  }
  const auto ground = aerial::findGround(hand.cloud, {}, 1);
  const auto& classes = ground.classification;
  EXPECT_EQ(classes[classes.size() - 2], 7);
  EXPECT_EQ(classes.back(), 18);
  EXPECT_EQ(ground.unusedPoints, 2U);
}

TEST(UsablePoints, AreThoseThatAreFiniteAndNotWithheld)
{
  HandCloud hand;
  hand.add(0, 0, 0, true);
  hand.add(1, 0, NAN, true);
  hand.add(INFINITY, 0, 0, true);
  hand.add(2, 0, 0, true);
  hand.cloud.withheld = {0, 0, 0, 1};
  EXPECT_EQ(aerial::usablePoints(hand.cloud), (aerial::UsedPoints{1, 0, 0, 0}));
  hand.cloud.withheld = {1, 1, 1, 1};
  EXPECT_THROW(aerial::usablePoints(hand.cloud), std::runtime_error);
}
