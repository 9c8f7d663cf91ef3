#include <gtest/gtest.h>

#include <cmath>

#include "../mrpt_mapconv/src/aerial/GroundMap.h"
#include "HandCloud.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;

/** Cells of 0.25 m from the origin on; the filter's are 0.5 m, centred on multiples of that. */
aerial::GroundLayers mapOf(const HandCloud& hand, const aerial::UsedPoints& used)
{
  grid::GridFrame filter;
  filter.resolution = 0.5;
  filter.shift = -0.5;
  filter.width = filter.height = 4;
  grid::Layer<float> surface(filter, 0);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) surface.at(x, y) = static_cast<float>(10 * y + x);
  grid::GridFrame frame;
  frame.resolution = 0.25;
  frame.width = frame.height = 5;
  return aerial::mapGround(hand.cloud, used, hand.truth, surface, frame);
}
}  // namespace

TEST(GroundMap, ACellHasItsLowestGroundPointAndItsHighestPoint)
{
  HandCloud hand;
  hand.add(0.3, 0.1, 2.5, true);
  hand.add(0.3, 0.2, 2.25, true);
  hand.add(0.3, 0.1, 1, false);
  hand.add(0.3, 0.1, 9, false);
  hand.add(0.3, 0.1, 50, true);
  const auto layers = mapOf(hand, {1, 1, 1, 1, 0});
  EXPECT_EQ(layers.ground.at(1, 0), 2.25F);
  EXPECT_EQ(layers.evidence.at(1, 0), 1);
  EXPECT_EQ(layers.surface.at(1, 0), 9);
  EXPECT_EQ(layers.aboveGround.at(1, 0), 6.75F);
  EXPECT_EQ(layers.groundPoints.at(1, 0), 2);
  EXPECT_EQ(layers.allPoints.at(1, 0), 4);
}

TEST(GroundMap, ACellWithoutAGroundPointLiesBetweenTheNearestParticles)
{
  HandCloud hand;
  hand.add(0.1, 0.1, 7, false);
  const auto layers = mapOf(hand, {1});
  EXPECT_EQ(layers.ground.at(0, 0), 2.75F);   // centre (0.125, 0.125): between 0, 1, 10 and 11
  EXPECT_EQ(layers.ground.at(1, 0), 3.25F);   // (0.375, 0.125)
  EXPECT_EQ(layers.ground.at(2, 3), 18.75F);  // (0.625, 0.875): between 11, 12, 21 and 22
  EXPECT_EQ(layers.evidence.at(0, 0), 2);
  EXPECT_EQ(layers.groundPoints.at(0, 0), 0);
  EXPECT_EQ(layers.allPoints.at(0, 0), 1);
  EXPECT_EQ(layers.aboveGround.at(0, 0), 4.25F);
}

TEST(GroundMap, ACellWithoutPointsHasNoSurface)
{
  HandCloud hand;
  hand.add(0.1, 0.1, 7, true);
  const auto layers = mapOf(hand, {1});
  EXPECT_TRUE(std::isnan(layers.surface.at(4, 4)));
  EXPECT_TRUE(std::isnan(layers.aboveGround.at(4, 4)));
}

TEST(GroundMap, TheSurfaceIsNeverBelowTheGround)
{
  HandCloud hand;
  hand.add(1.1, 0.6, 3, false);  // a particle is at 12
  EXPECT_EQ(mapOf(hand, {1}).aboveGround.at(4, 2), 0);
}
