// planOnGrid against brute force on random maps.
#include <gtest/gtest.h>
#include <mrpt_mapconv/planning/GridPlanner.h>

#include <cmath>
#include <random>

#include "../../oracle/PlanOracle.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::planning;
using mrpt::math::TPoint2D;
using mrpt_mapconv::test::PlanOracle;
using Rng = std::mt19937;

int pick(Rng& rng, int low, int high) { return std::uniform_int_distribution<int>(low, high)(rng); }
double uniform(Rng& rng) { return std::uniform_real_distribution<double>(0, 1)(rng); }

/** Cells of noise, or walls with doors. */
grid::Layer<float> randomMap(Rng& rng)
{
  const double resolutions[] = {0.1, 0.05, 0.25, 1.0, 0.3};
  grid::Layer<float> map({resolutions[pick(rng, 0, 4)], pick(rng, -40, 40), pick(rng, -40, 40),
                          pick(rng, 1, 26), pick(rng, 1, 26)},
                         0.0f);
  const auto& frame = map.frame();
  const float values[] = {-1.0f, 0.1f, 1.0f};
  const auto blocked = [&] { return values[pick(rng, 0, 2)]; };
  const double density = uniform(rng) < 0.3 ? 0.0 : 0.45 * uniform(rng);
  for (float& cell : map.cells())
    if (uniform(rng) < density) cell = blocked();
  for (int walls = pick(rng, 0, 3); walls > 0; --walls)
  {
    const bool column = pick(rng, 0, 1) == 0;
    const int at = pick(rng, 0, (column ? frame.width : frame.height) - 1);
    const int along = column ? frame.height : frame.width;
    const int door = pick(rng, 0, along - 1), size = pick(rng, 0, 7);
    for (int i = 0; i < along; ++i)
      if (i < door || i >= door + size) (column ? map.at(at, i) : map.at(i, at)) = blocked();
  }
  return map;
}

struct Place
{
  std::int32_t ix, iy;
  TPoint2D point;
};

/** Anywhere in a random cell, sometimes on its lower sides. */
Place randomPlace(Rng& rng, const grid::GridFrame& frame)
{
  const int ix = pick(rng, 0, frame.width - 1), iy = pick(rng, 0, frame.height - 1);
  const auto within = [&] { return pick(rng, 0, 5) == 0 ? 0.0 : 0.001 + 0.998 * uniform(rng); };
  return {ix,
          iy,
          {(frame.x0 + ix + within()) * frame.resolution,
           (frame.y0 + iy + within()) * frame.resolution}};
}

double pathLength(const std::vector<TPoint2D>& points)
{
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

struct Tally
{
  int found = 0, notConnected = 0, badEnd = 0;
  double worst = 0;  //!< length over that of the shortest way over cells
};

void checkOnce(unsigned seed, Tally& tally)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  Rng rng(seed);
  const auto map = randomMap(rng);
  const double resolution = map.frame().resolution;
  const double radii[] = {0, 0, 1, 2, 0.4, 1.5, 1.41, 3 * uniform(rng)};
  const double radius = radii[pick(rng, 0, 7)] * resolution;
  const PlanOracle oracle(map, radius);
  Place start = randomPlace(rng, map.frame()), goal = randomPlace(rng, map.frame());
  for (int tries = 0; tries < 30 && !oracle.passable(start.ix, start.iy); ++tries)
    start = randomPlace(rng, map.frame());
  for (int tries = 0; tries < 30 && !oracle.passable(goal.ix, goal.iy); ++tries)
    goal = randomPlace(rng, map.frame());

  const GridPath path = planOnGrid(map, start.point, goal.point, radius);
  if (!oracle.passable(start.ix, start.iy) || !oracle.passable(goal.ix, goal.iy))
  {
    ++tally.badEnd;
    const bool startIsBad = !oracle.passable(start.ix, start.iy);
    ASSERT_EQ(path.problem.rfind(startIsBad ? "start (" : "goal (", 0), 0u) << path.problem;
    ASSERT_EQ(path.problem.find("not connected"), std::string::npos) << path.problem;
    return;
  }
  const double shortest = oracle.shortestWay(start.ix, start.iy, goal.ix, goal.iy);
  ASSERT_EQ(path.found(), std::isfinite(shortest)) << path.problem;
  if (!path.found())
  {
    ++tally.notConnected;
    ASSERT_NE(path.problem.find("not connected"), std::string::npos) << path.problem;
    return;
  }
  ++tally.found;
  ASSERT_EQ(path.points.front(), start.point);
  ASSERT_EQ(path.points.back(), goal.point);
  ASSERT_EQ(oracle.fault(path.points), "");
  const double length = pathLength(path.points);
  // a diagonal step goes over two sides, √2 times as long; and from place to centre at both ends
  ASSERT_LE(length, std::sqrt(2.0) * (shortest + resolution) + 1e-9);
  if (shortest < 10 * resolution) return;
  tally.worst = std::max(tally.worst, length / shortest);
}

TEST(GridPlannerRandom, isRightOnRandomMaps)
{
  Tally tally;
  for (unsigned seed = 0; seed < 3000 && !HasFatalFailure(); ++seed) checkOnce(seed, tally);
  EXPECT_GT(tally.found, 500);
  EXPECT_GT(tally.notConnected, 200);
  EXPECT_GT(tally.badEnd, 100);
  RecordProperty("longest_over_shortest", std::to_string(tally.worst));
}

}  // namespace
