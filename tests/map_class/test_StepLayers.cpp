#include <gtest/gtest.h>

#include <cmath>

#include "step_grid/StepLayers.h"

using namespace step_grid;

TEST(StepLayers, KeepTheLowestAndTheHighestPointOfACell)
{
  StepLayers layers(0.5);
  const auto changed =
      layers.insert({{0.1, 0.1, 1}, {0.4, 0.4, 1.1}, {0.2, 0.2, 0.9}, {-0.1, 0.1, 2}}, 0.3);
  EXPECT_EQ(changed.size(), 2u);
  const auto& frame = layers.lowest.frame();
  const auto at = [&](const auto& layer, int kx, int ky)
  { return layer.cells()[frame.indexOfKey(kx, ky)]; };
  EXPECT_FLOAT_EQ(at(layers.lowest, 0, 0), 0.9f);
  EXPECT_FLOAT_EQ(at(layers.highest, 0, 0), 1.1f);
  EXPECT_EQ(at(layers.occupancy, 0, 0), 0);
  EXPECT_EQ(at(layers.occupancy, -1, 0), 0);

  layers.insert({{0.1, 0.1, 1.3}}, 0.3);
  EXPECT_EQ(at(layers.occupancy, 0, 0), 1) << "0.9 to 1.3 m is a step";
}

TEST(StepLayers, GrowAndKeepWhatTheyHave)
{
  StepLayers layers(0.5);
  layers.insert({{0.1, 0.1, 1}}, 0.3);
  layers.insert({{10.1, -5.1, 2}}, 0.3);
  const auto& frame = layers.lowest.frame();
  ASSERT_TRUE(frame.containsKey(0, 0) && frame.containsKey(20, -11));
  EXPECT_EQ(layers.lowest.cells()[frame.indexOfKey(0, 0)], 1);
  EXPECT_EQ(layers.lowest.cells()[frame.indexOfKey(20, -11)], 2);
  EXPECT_TRUE(std::isnan(layers.lowest.cells()[frame.indexOfKey(10, -5)]));
  EXPECT_EQ(layers.occupancy.frame(), frame);
}

TEST(StepLayers, RefuseWhatIsTooFarAway)
{
  StepLayers layers(0.01);
  layers.insert({{0, 0, 0}}, 0.3);
  const auto frame = layers.lowest.frame();
  EXPECT_THROW(layers.insert({{500000, 500000, 0}}, 0.3), std::runtime_error);
  EXPECT_THROW(layers.insert({{NAN, 0, 0}}, 0.3), std::runtime_error);
  EXPECT_EQ(layers.lowest.frame(), frame);
}
