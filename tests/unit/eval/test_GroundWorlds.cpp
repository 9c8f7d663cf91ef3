// The forests whose ground is looked for are what their comments say.
#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/LabelledCloud.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace mrpt_mapconv;

sim::Scenario load(const std::string& name)
{
  return sim::Scenario::load(MRPT_MAPCONV_SOURCE_DIR "/config/worlds/ground_" + name + ".ini");
}

/** Slopes of the ground over 1 m, ascending [degrees]. */
std::vector<double> slopesOf(const sim::World& world)
{
  grid::GridFrame frame;
  frame.resolution = 0.5;
  frame.x0 = frame.y0 = -100;
  frame.width = frame.height = 200;
  const auto ground = eval::trueGround(world, frame);
  std::vector<double> slopes;
  for (std::int32_t y = 1; y + 1 < frame.height; ++y)
    for (std::int32_t x = 1; x + 1 < frame.width; ++x)
      slopes.push_back(std::atan(std::hypot(ground.at(x + 1, y) - ground.at(x - 1, y),
                                            ground.at(x, y + 1) - ground.at(x, y - 1))) *
                       180 / 3.14159265358979);
  std::sort(slopes.begin(), slopes.end());
  return slopes;
}

double quantile(const std::vector<double>& values, double share)
{
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}
}  // namespace

TEST(GroundWorlds, AreSeenByManyBeamsOfWhichFewReachTheGround)
{
  for (const char* name : {"gentle", "steep", "steps"})
  {
    SCOPED_TRACE(name);
    const auto labelled = eval::simulateCloud(load(name), 1);
    const auto points = static_cast<double>(labelled.cloud.size());
    EXPECT_GE(points, 3e5);
    EXPECT_LE(points, 1e6);  // at least 30 a square metre
    EXPECT_GE(static_cast<double>(labelled.groundPoints()) / points, 0.015);
    EXPECT_LE(static_cast<double>(labelled.groundPoints()) / points, 0.03);
  }
}

TEST(GroundWorlds, HaveTheirSlopes)
{
  const auto gentle = slopesOf(load("gentle").world), steep = slopesOf(load("steep").world);
  EXPECT_LE(quantile(gentle, 0.99), 10);
  EXPECT_GE(quantile(gentle, 0.5), 3);
  EXPECT_GE(quantile(steep, 0.01), 25);
  EXPECT_LE(quantile(steep, 0.99), 35);
}

TEST(GroundWorlds, StepsAreHalfAMetreToOneAndAHalf)
{
  const sim::Scenario scenario = load("steps");
  // across the slope, faces are two squares of the lattice wide at most
  std::size_t steps = 0;
  for (double y = -45; y < 45; y += 0.9)
    for (double x = -49; x < 49; x += 0.5)
    {
      const double rise = *scenario.world.groundAt(x + 0.5, y) - *scenario.world.groundAt(x, y);
      steps += std::abs(rise) > 0.45 ? 1 : 0;
      EXPECT_LE(std::abs(rise), 1.6) << x << " " << y;
    }
  EXPECT_GE(steps, 300u);
}
