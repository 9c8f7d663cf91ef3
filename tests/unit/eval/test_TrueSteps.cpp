#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/eval/TrueSteps.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using namespace mrpt_mapconv;
using eval::TrueStep;
using terrain::TerrainStep;

namespace
{
/** Two steps up to a platform, then down to the floor, and a ramp. */
sim::World world()
{
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(
      "[world]\nbounds = 0 0 -1  8 2 3\n"
      "[box.floor]\nmin = -1 -1 -1\nmax = 9 3 0\n"
      "[stairs.s]\nmin = 1.0123 0 0\nmax = 1.6123 2 0.34\ndirection = +x\nsteps = 2\n"
      "[box.platform]\nmin = 1.6123 0 0\nmax = 3 2 0.51\n"
      "[ramp.r]\nmin = 4 0 0\nmax = 6 2 0.5\ndirection = +x\n"
      "[box.shelf]\nmin = 6.5 0 1\nmax = 7 2 1.1\n");
  return sim::World::fromIni(ini, {});
}

std::vector<TrueStep> stepsOf(double x0, double x1)
{
  return eval::trueSteps(world(), {x0, 1}, {x1, 1}, 0.03);
}
}  // namespace

TEST(TrueSteps, StairsUp)
{
  const auto steps = stepsOf(0.5, 2);
  ASSERT_EQ(steps.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(steps[i].x, 1.0123 + 0.3 * static_cast<double>(i), 1e-6);
    EXPECT_NEAR(steps[i].y, 1, 1e-12);
    EXPECT_NEAR(steps[i].height, 0.17, 1e-9);
    EXPECT_NEAR(steps[i].directionX, 1, 1e-12);
    EXPECT_NEAR(steps[i].directionY, 0, 1e-12);
  }
  EXPECT_NEAR(steps[0].depth, 0.3, 1e-6);
  EXPECT_NEAR(steps[1].depth, 0.3, 1e-6);
  EXPECT_TRUE(std::isnan(steps[2].depth)) << "the platform does not end on the line";
}

TEST(TrueSteps, TheOtherWayIsTheSame)
{
  const auto up = stepsOf(0.5, 2), down = stepsOf(2, 0.5);
  ASSERT_EQ(down.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(down[2 - i].x, up[i].x, 1e-6);
    EXPECT_NEAR(down[2 - i].height, up[i].height, 1e-9);
    EXPECT_NEAR(down[2 - i].directionX, up[i].directionX, 1e-12);
  }
  EXPECT_NEAR(down[2].depth, 0.3, 1e-6);
  EXPECT_TRUE(std::isnan(down[0].depth));
}

TEST(TrueSteps, AnUpperTreadEndsAtTheNextStepUpOrDown)
{
  const auto steps = stepsOf(1.5, 3.5);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_NEAR(steps[0].depth, 3 - 1.6123, 1e-6);
  EXPECT_NEAR(steps[1].x, 3, 1e-6);
  EXPECT_NEAR(steps[1].height, 0.51, 1e-9);
  EXPECT_NEAR(steps[1].directionX, -1, 1e-12);
  EXPECT_NEAR(steps[1].depth, 3 - 1.6123, 1e-6);
}

TEST(TrueSteps, RampsAndWhatHangsAboveAreNoSteps)
{
  EXPECT_EQ(stepsOf(3.5, 5.9).size(), 0u);
  EXPECT_EQ(stepsOf(6.2, 7.5).size(), 0u);
  EXPECT_EQ(stepsOf(5.9, 6.2).size(), 1u) << "where the ramp ends";
}

TEST(TrueSteps, ALineAcrossSeesTheTreadsLonger)
{
  const auto steps = eval::trueSteps(world(), {0.8, 0.2}, {1.8, 1.2}, 0.03);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_NEAR(steps[0].depth, 0.3 * std::sqrt(2.0), 1e-6);
}

TEST(TrueSteps, BadLinesAreRefused)
{
  EXPECT_THROW(stepsOf(1, 1), std::invalid_argument);
  EXPECT_THROW(eval::trueSteps(world(), {0, 1}, {1, 1}, 0), std::invalid_argument);
}

namespace
{
TerrainStep mapStep(double x, double y, double directionX, double directionY, double width)
{
  TerrainStep step;
  step.x = x;
  step.y = y;
  step.directionX = directionX;
  step.directionY = directionY;
  step.width = width;
  return step;
}

const TrueStep kTruth{1, 1, 1, 0, 0.2, 0.3};
}  // namespace

TEST(TrueSteps, TheNearestStepStandsForIt)
{
  const std::vector<TerrainStep> steps = {mapStep(0.95, 1, 1, 0, 1), mapStep(1.02, 1, 1, 0, 1),
                                          mapStep(1.08, 1, 1, 0, 1)};
  const auto found = eval::stepFor(kTruth, steps, 0.1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->x, 1.02);
}

TEST(TrueSteps, OthersDoNot)
{
  const auto isFound = [](const TerrainStep& step)
  { return eval::stepFor(kTruth, {step}, 0.1).has_value(); };
  EXPECT_TRUE(isFound(mapStep(1.09, 1, 1, 0, 1)));
  EXPECT_FALSE(isFound(mapStep(1.11, 1, 1, 0, 1))) << "too far in its direction";
  EXPECT_FALSE(isFound(mapStep(1, 1, -1, 0, 1))) << "the other way up";
  EXPECT_TRUE(isFound(mapStep(1, 1, 0.95, std::sqrt(1 - 0.95 * 0.95), 1)));
  EXPECT_FALSE(isFound(mapStep(1, 1, 0.85, std::sqrt(1 - 0.85 * 0.85), 1))) << "too slanted";
  EXPECT_TRUE(isFound(mapStep(1, 1.5, 1, 0, 1)));
  EXPECT_FALSE(isFound(mapStep(1, 1.7, 1, 0, 1))) << "ends beside the line";
}

namespace
{
/** A way through places at height 1 m, a second apart. */
sim::Trajectory wayThrough(const std::vector<mrpt::math::TPoint2D>& places)
{
  std::vector<sim::Trajectory::Knot> knots;
  for (const auto& place : places)
  {
    sim::Trajectory::Knot knot;
    knot.time = static_cast<double>(knots.size());
    knot.position = {place.x, place.y, 1};
    knots.push_back(knot);
  }
  return sim::Trajectory(knots);
}
}  // namespace

TEST(TrueSteps, AWayGoesStraightOnOverItsKnots)
{
  const auto steps =
      eval::trueSteps(world(), wayThrough({{0.5, 1}, {1.2, 1}, {1.2, 1}, {1.5, 1}, {2, 1}}), 0.03);
  const auto line = stepsOf(0.5, 2);
  ASSERT_EQ(steps.size(), line.size());
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    EXPECT_NEAR(steps[i].x, line[i].x, 1e-6);
    EXPECT_NEAR(steps[i].depth, line[i].depth, 1e-6) << "the tread does not end at a knot";
  }
}

TEST(TrueSteps, AWayThatTurnsHasThoseOfEachPiece)
{
  const auto steps =
      eval::trueSteps(world(), wayThrough({{0.5, 1}, {2, 1}, {2, 0.5}, {0.5, 0.5}}), 0.03);
  ASSERT_EQ(steps.size(), 6u);
  EXPECT_NEAR(steps.front().y, 1, 1e-9);
  EXPECT_NEAR(steps.back().y, 0.5, 1e-9);
  EXPECT_NEAR(steps.back().x, steps.front().x, 1e-6);
}

TEST(TrueSteps, AMapIsMatchedStepByStep)
{
  terrain::TerrainMap map(0.05);
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 20; ++y) map.insertPoint(0.05 * x, 0.05 * y, x < 20 ? 0 : 0.21, 0.001);
  map.update(1);
  const TrueStep here{0.97, 0.5, 1, 0, 0.2, 1}, elsewhere{1.5, 0.5, 1, 0, 0.2, 1};
  const auto matches = eval::matchSteps({here, elsewhere}, map);
  ASSERT_EQ(matches.size(), 2u);
  ASSERT_TRUE(matches[0].found);
  EXPECT_NEAR(matches[0].heightError(), 0.01, 1e-4);
  EXPECT_NEAR(matches[0].depthError(), 0, 1e-9);
  EXPECT_FALSE(matches[1].found);
  EXPECT_TRUE(std::isnan(matches[1].heightError()));
}
