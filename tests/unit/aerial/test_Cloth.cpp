#include <gtest/gtest.h>

#include <algorithm>

#include "../mrpt_mapconv/src/aerial/Cloth.h"
#include "../mrpt_mapconv/src/aerial/SlopeSmoothing.h"

namespace
{
using namespace mrpt_mapconv;
using grid::Layer;

Layer<float> flat(int width, int height, float z)
{
  grid::GridFrame frame;
  frame.resolution = 0.5;
  frame.width = width;
  frame.height = height;
  return {frame, z};
}

/** A square of that side in the middle, so much higher. */
Layer<float> withBlock(int side, float height)
{
  auto surface = flat(61, 61, 0);
  for (int y = 30 - side / 2; y <= 30 + side / 2; ++y)
    for (int x = 30 - side / 2; x <= 30 + side / 2; ++x) surface.at(x, y) = height;
  return surface;
}
}  // namespace

TEST(Cloth, LiesOnLevelGround)
{
  const auto surface = flat(40, 50, 120);
  aerial::Cloth cloth(surface, {}, 1);
  EXPECT_LT(cloth.settle(), 10);
  const auto heights = cloth.heights();
  for (const float z : heights.cells()) EXPECT_EQ(z, 120);
  EXPECT_TRUE(cloth.isFixed(0));
}

TEST(Cloth, LiesOnASlope)
{
  auto surface = flat(60, 60, 0);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) surface.at(x, y) = 0.25F * static_cast<float>(x);
  aerial::Cloth cloth(surface, {}, 1);
  cloth.settle();
  for (std::size_t i = 0; i < surface.cells().size(); ++i)
    EXPECT_LT(cloth.gap(i), 0.2) << "column " << i % 60;
}

TEST(Cloth, SpansAHouse)
{
  const auto surface = withBlock(20, 8);
  aerial::Cloth cloth(surface, {}, 1);
  cloth.settle();
  const auto heights = cloth.heights();
  EXPECT_LT(heights.at(30, 30), 4);
  EXPECT_FALSE(cloth.isFixed(surface.frame().indexOfKey(30, 30)));
  EXPECT_EQ(heights.at(5, 5), 0);
}

TEST(Cloth, AStiffOneRisesLessUnderAHouse)
{
  const auto surface = withBlock(20, 50);
  float before = 1e9F;
  for (const int rigidness : {1, 2, 3})
  {
    aerial::GroundParams params;
    params.rigidness = rigidness;
    aerial::Cloth cloth(surface, params, 1);
    cloth.settle();
    EXPECT_LT(cloth.heights().at(30, 30), before) << rigidness;
    before = cloth.heights().at(30, 30);
  }
}

TEST(Cloth, NeverPassesTheSurface)
{
  auto surface = flat(50, 50, 3);
  for (std::size_t i = 0; i < surface.cells().size(); ++i)
    surface.cells()[i] += static_cast<float>(i * 7919 % 101) / 50;
  aerial::Cloth cloth(surface, {}, 1);
  cloth.settle();
  for (std::size_t i = 0; i < surface.cells().size(); ++i) EXPECT_GE(cloth.gap(i), 0);
}

TEST(Cloth, StopsAfterTheGivenSteps)
{
  aerial::GroundParams params;
  params.maxIterations = 3;
  aerial::Cloth cloth(withBlock(20, 50), params, 1);
  EXPECT_EQ(cloth.settle(), 3);
}

TEST(SlopeSmoothing, DrawsTheClothOnToAHilltopAndNotToARoof)
{
  const auto roof = withBlock(20, 3);
  auto hill = flat(61, 61, 0);
  for (int y = 0; y < 61; ++y)
    for (int x = 0; x < 61; ++x)
    {
      const int d2 = (x - 30) * (x - 30) + (y - 30) * (y - 30);
      hill.at(x, y) = std::max(0.0F, 3 - static_cast<float>(d2) / 100);
    }
  const auto isTopReached = [](const Layer<float>& surface)
  {
    aerial::Cloth cloth(surface, {}, 1);
    cloth.settle();
    const auto top = surface.frame().indexOfKey(30, 30);
    EXPECT_FALSE(cloth.isFixed(top));
    aerial::drawOn(cloth, surface, {}, 1);
    return cloth.isFixed(top);
  };
  EXPECT_TRUE(isTopReached(hill));
  EXPECT_FALSE(isTopReached(roof));
}
