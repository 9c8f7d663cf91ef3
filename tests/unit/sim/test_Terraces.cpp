#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/World.h>

#include <string>
#include <vector>

#include "WorldText.h"

namespace
{
using namespace mrpt_mapconv::sim;
using mrpt_mapconv::test::solidsAt;
using mrpt_mapconv::test::worldOf;
}  // namespace

TEST(Terraces, RiseBySteps)
{
  const World world = worldOf(
      "[heightField.g]\nmin = 0 0\nmax = 40 2\ncell = 0.05\nsolid = below\ngradient = 0.2 0\n"
      "terraces = 0.5 1.5\n");
  std::vector<double> levels;
  for (double x = 0.01; x < 40; x += 0.05)
  {
    const double z = world.groundAt(x, 1).value();
    EXPECT_NEAR(z, 0.2 * x, 1.5);
    if (levels.empty() || z > levels.back() + 0.4) levels.push_back(z);
  }
  for (std::size_t i = 2; i + 1 < levels.size(); ++i)
  {
    EXPECT_GE(levels[i] - levels[i - 1], 0.4);
    EXPECT_LE(levels[i] - levels[i - 1], 1.51);
  }
  EXPECT_GE(levels.size(), 6u);
  EXPECT_LE(levels.size(), 17u);
}

TEST(Terraces, TiltIsTheShareThatIsNoStep)
{
  const std::string keys =
      "[heightField.g]\nmin = 0 0\nmax = 40 2\ncell = 0.05\nsolid = below\ngradient = 0.2 0\n";
  const World all = worldOf(keys + "terraces = 0.5 1.5\nterraceTilt = 1\n"), none = worldOf(keys);
  const World part = worldOf(keys + "terraces = 1 1\nterraceTilt = 0.4\n");
  for (double x = 0.01; x < 40; x += 0.37)
    EXPECT_NEAR(all.groundAt(x, 1).value(), none.groundAt(x, 1).value(), 1e-5);
  // a terrace is 5 m long
  EXPECT_NEAR(part.groundAt(9, 1).value(), 1 + 0.4 * 0.8, 1e-5);
  EXPECT_NEAR(solidsAt(part, 9, 1)[0].slope, 0.4 * 0.2, 1e-4);
}
