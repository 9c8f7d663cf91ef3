// Many trees and logs at once.
#include <gtest/gtest.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/sim/World.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "PlantWorlds.h"
#include "WorldText.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;
using namespace mrpt_mapconv::test;

const std::string kForest =
    "[forest.a]\nmin = -15 -15\nmax = 15 15\ntreesPerHectare = 500\nspacing = 1.5\n"
    "height = 8 12\ntrunkRadius = 0.1 0.3\ncrownRadius = 1 3\ncrownBase = 0.3 0.5\n"
    "density = 0.5\nlogsPerHectare = 100\nlogLength = 2 5\nlogRadius = 0.1 0.2\n";
}  // namespace

TEST(Forests, ForestHasAsManyTreesAndLogsAsItsAreaTakes)
{
  const World world = worldOf(kFlat + kForest);
  std::size_t crowns = 0, timber = 0;
  for (std::size_t i = 1; i < world.size(); ++i)
  {
    EXPECT_EQ(world.name(i), "forest.a");
    ++(world.primitive(i).foliage() ? crowns : timber);
  }
  EXPECT_EQ(crowns, 45u);  // 500 on a hectare, on 0.09
  EXPECT_EQ(timber, 45u + 9u);
}

TEST(Forests, TreesOfAForestKeepWithinTheirLimits)
{
  std::string forest = kForest;
  forest.replace(forest.find("-15 -15"), 7, "-9 -9");
  forest.replace(forest.find("15 15"), 5, "9 9");
  const World world = worldOf(kSlope + forest);
  std::vector<mrpt::math::TPoint2D> places;
  for (std::size_t i = 1; i < world.size(); ++i)
  {
    const Foliage* crown = world.primitive(i).foliage();
    if (!crown) continue;
    const auto [low, high] = crown->boundsOf(0);
    const double x = (low.x + high.x) / 2, y = (low.y + high.y) / 2;
    const double ground = world.groundAt(x, y).value(), height = high.z - ground;
    EXPECT_GE(height, 8 - 1e-6);
    EXPECT_LE(height, 12 + 1e-6);
    EXPECT_GE((low.z - ground) / height, 0.3 - 1e-6);
    EXPECT_LE((low.z - ground) / height, 0.5 + 1e-6);
    EXPECT_GE(high.x - low.x, 2 - 1e-6);
    EXPECT_LE(high.x - low.x, 6 + 1e-6);
    EXPECT_LE(std::max(std::abs(x), std::abs(y)), 9);
    for (const auto& other : places) EXPECT_GE(std::hypot(x - other.x, y - other.y), 1.5 - 1e-6);
    places.push_back({x, y});
    // its trunk ends in the crown's middle
    const auto timber = plantsAt(world, x, y);
    ASSERT_FALSE(timber.empty());
    EXPECT_NEAR(timber[0].top, (low.z + high.z) / 2, 1e-6);
  }
  EXPECT_EQ(places.size(), 16u);
}

TEST(Forests, ForestDependsOnItsSeedAlone)
{
  const auto boundsOf = [](const World& world)
  {
    std::string text;
    for (std::size_t i = 1; i < world.size(); ++i)
    {
      const Footprint f = world.primitive(i).footprint();
      text += std::to_string(f.xMin) + " " + std::to_string(f.yMax) + "\n";
    }
    return text;
  };
  const std::string one = boundsOf(worldOf(kFlat + kForest));
  EXPECT_EQ(one, boundsOf(worldOf(kForest + kFlat)));
  EXPECT_NE(one, boundsOf(worldOf(kFlat + kForest + "seed = 2\n")));
}

namespace
{
struct BadForest
{
  const char *key, *value, *error;
};
class BadForests : public testing::TestWithParam<BadForest>
{
};
const BadForest kBadForests[] = {
    {"treesPerHectare", "-1", "a number >= 0, for at most 1e5"},
    {"spacing", "-1", "a distance >= 0 [m]"},
    {"spacing", "9", "so small that all trees find room in the area"},
    {"height", "9 8", "two numbers, lowest and highest, 0 < lowest <= highest"},
    {"trunkRadius", "0 1", "two numbers, lowest and highest, 0 < lowest <= highest"},
    {"crownRadius", "1", "two numbers, lowest and highest, 0 < lowest <= highest"},
    {"crownBase", "0.5 1", "shares of the height, below 1"},
    {"density", "-2", "a number > 0"},
    {"logLength", "99 99", "so small that logs find room in the area"},
    {"logRadius", "", "given: two numbers, lowest and highest, 0 < lowest <= highest"},
    {"max", "30 15", "such that there is ground (of a heightField) in all of the area"},
};
}  // namespace

TEST_P(BadForests, GetAnErrorThatNamesTheKey)
{
  const auto& [key, value, right] = GetParam();
  std::string text = kForest;
  const auto begin = text.find("\n" + std::string(key) + " =") + 1, end = text.find('\n', begin);
  text.replace(begin, end - begin, *value ? std::string(key) + " = " + value : "");
  try
  {
    worldOf(kFlat + text);
    FAIL() << "no error for " << text;
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(error.what(), std::string("section 'forest.a': ") + key + " = '" + value +
                                "' is not valid: it must be " + right);
  }
}

TEST(Forests, ForestsHaveAtMostAHundredThousandTrees)
{
  std::string forest = kForest;
  forest.replace(forest.find("-15 -15"), 7, "-20 -20");
  forest.replace(forest.find("15 15"), 5, "20 20");
  forest.replace(forest.find("500"), 3, "9e5");
  EXPECT_THROW(worldOf(kFlat + forest), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(Plants, BadForests, testing::ValuesIn(kBadForests));
