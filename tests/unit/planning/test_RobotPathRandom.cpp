// planRobotPath against brute force on random layers.
#include <gtest/gtest.h>
#include <mrpt_mapconv/planning/GridPlanner.h>
#include <mrpt_mapconv/planning/RobotPath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../../oracle/LiftOracle.h"
#include "../../oracle/PlanOracle.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::planning;
using mrpt::math::TPoint2D;
using oracle::LiftOracle;
using Rng = std::mt19937;

int pick(Rng& rng, int low, int high) { return std::uniform_int_distribution<int>(low, high)(rng); }
double uniform(Rng& rng) { return std::uniform_real_distribution<double>(0, 1)(rng); }

/** Rectangles of floors, ceilings and walls, so that the sphere fits in on most of them, but not
 * across many of their borders. */
freespace::Layers randomLayers(Rng& rng, double minClearance)
{
  const double resolutions[] = {0.1, 0.25, 0.3};
  freespace::Layers layers(grid::GridFrame{resolutions[pick(rng, 0, 2)], pick(rng, -40, 40),
                                           pick(rng, -40, 40), pick(rng, 6, 26), pick(rng, 6, 26)});
  const auto& frame = layers.frame();
  for (int patch = 0, last = pick(rng, 0, 18); patch <= last; ++patch)
  {
    const bool all = patch == 0;
    const int x = all ? 0 : pick(rng, 0, frame.width - 1);
    const int y = all ? 0 : pick(rng, 0, frame.height - 1);
    const int xEnd = all ? frame.width : std::min(frame.width, x + pick(rng, 1, 8));
    const int yEnd = all ? frame.height : std::min(frame.height, y + pick(rng, 1, 8));
    const bool blocked = !all && pick(rng, 0, 3) == 0;
    const float occupancy = !blocked ? 0.0f : pick(rng, 0, 2) == 0 ? -1.0f : 1.0f;
    const double floor = 0.5 * minClearance * pick(rng, 0, 3);
    const double ceiling = floor + minClearance * (1 + 0.5 * pick(rng, 0, 2));
    for (int iy = y; iy < yEnd; ++iy)
      for (int ix = x; ix < xEnd; ++ix)
      {
        layers.floor.at(ix, iy) =
            blocked ? freespace::Layers::kNone : static_cast<float>(floor + 0.02 * uniform(rng));
        layers.ceiling.at(ix, iy) =
            blocked ? freespace::Layers::kNone : static_cast<float>(ceiling + 0.05);
        layers.aerial.at(ix, iy) = layers.ground.at(ix, iy) = occupancy;
      }
  }
  return layers;
}

/** Cells in whose centres the robot can be, and how they hang together. */
class Places
{
 public:
  Places(const freespace::Layers& layers, const test::PlanOracle& disc, const LiftOracle& sphere)
      : m_good(layers.frame(), 0)
  {
    for (int iy = 0; iy < layers.frame().height; ++iy)
      for (int ix = 0; ix < layers.frame().width; ++ix)
        m_good.at(ix, iy) = disc.passable(ix, iy) && fits(sphere, centre(ix, iy));
  }

  TPoint2D centre(int ix, int iy) const
  {
    const auto& frame = m_good.frame();
    return {(frame.x0 + ix + 0.5) * frame.resolution, (frame.y0 + iy + 0.5) * frame.resolution};
  }

  static bool fits(const LiftOracle& sphere, const TPoint2D& place)
  {
    std::vector<path::LiftedPoint> points(1);
    points[0].position = {place.x, place.y, 0};
    return sphere.lift(points)[0].problem == path::Infeasibility::None;
  }

  bool good(int ix, int iy) const
  {
    return ix >= 0 && iy >= 0 && ix < m_good.frame().width && iy < m_good.frame().height &&
           m_good.at(ix, iy) != 0;
  }

  bool connected(int fromX, int fromY, int toX, int toY) const
  {
    grid::Layer<char> reached(m_good.frame(), 0);
    std::vector<std::pair<int, int>> open{{fromX, fromY}};
    while (!open.empty())
    {
      const auto [x, y] = open.back();
      open.pop_back();
      if (!good(x, y) || reached.at(x, y)) continue;
      reached.at(x, y) = 1;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        open.emplace_back(x + dx, y + dy);
    }
    return reached.at(toX, toY) != 0;
  }

 private:
  grid::Layer<char> m_good;
};

struct Tally
{
  int connected = 0, detours = 0, onlyIn2D = 0, luck = 0, notIn2D = 0, small = 0;
};

/** Every point's sphere is clear, and the way keeps to what planOnGrid may use. */
void checkPath(const RobotPath& path, const RobotPathQuery& query, const test::PlanOracle& disc,
               const LiftOracle& sphere)
{
  ASSERT_TRUE(path.path.feasible());
  std::vector<TPoint2D> flat;
  for (const auto& point : path.path.points)
  {
    flat.emplace_back(point.position.x, point.position.y);
    for (const auto& demand : sphere.demands(point.position.x, point.position.y))
      ASSERT_TRUE(LiftOracle::satisfied(demand, point.position.z))
          << flat.back() << " at z = " << point.position.z;
  }
  ASSERT_EQ(flat.front(), query.start);
  ASSERT_EQ(flat.back(), query.goal);
  ASSERT_EQ(disc.fault(flat), "");
}

void checkOnce(unsigned seed, Tally& tally)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  Rng rng(seed);
  auto conversion = freespace::ConversionParams::paper();
  conversion.minClearance = 0.3 + uniform(rng);
  const auto layers = randomLayers(rng, conversion.minClearance);
  RobotPathQuery query;
  query.lift.safetyRadius = conversion.minClearance * (0.5 - 0.3 * uniform(rng));
  query.lift.heightOffset = uniform(rng);
  const double radii[] = {0, 0.5, 1, 1, 1.3};
  query.robotRadius = query.lift.safetyRadius * radii[pick(rng, 0, 4)];

  const test::PlanOracle disc(layers.aerial, query.robotRadius);
  const LiftOracle sphere(layers, conversion, query.lift, nullptr);
  const Places places(layers, disc, sphere);
  const auto somewhere = [&]() -> std::pair<int, int>
  {
    std::pair<int, int> cell;
    for (int tries = 0; tries < 60; ++tries)
    {
      cell = {pick(rng, 0, layers.frame().width - 1), pick(rng, 0, layers.frame().height - 1)};
      if (places.good(cell.first, cell.second)) break;
    }
    return cell;
  };
  const auto from = somewhere(), to = somewhere();
  query.start = places.centre(from.first, from.second);
  query.goal = places.centre(to.first, to.second);

  const RobotPath path = planRobotPath(layers, conversion, query);
  const bool plainIn2D =
      std::isfinite(disc.passable(from.first, from.second)
                        ? disc.shortestWay(from.first, from.second, to.first, to.second)
                        : std::numeric_limits<double>::infinity());
  if (path.found())
  {
    ASSERT_TRUE(plainIn2D);
    checkPath(path, query, disc, sphere);
  }
  if (places.connected(from.first, from.second, to.first, to.second))
  {
    // a sphere that does not reach the next cell may fit in here and there, but not on the way
    if (query.lift.safetyRadius < 0.5 * layers.frame().resolution && !path.found())
    {
      ++tally.small;
      ASSERT_NE(path.problem.find("at ("), std::string::npos) << path.problem;
      return;
    }
    ++tally.connected;
    ASSERT_TRUE(path.found()) << path.problem;
    const auto straight = planOnGrid(layers.aerial, query.start, query.goal, query.robotRadius);
    tally.detours += !path::liftPath(straight.points, layers, conversion, query.lift).feasible();
    return;
  }
  // a straight segment may pass through a bad cell where only its centre is bad
  tally.luck += path.found();
  if (path.found()) return;
  ++(plainIn2D ? tally.onlyIn2D : tally.notIn2D);
  const bool saysWhere = path.problem.find("not in 3D: at (") != std::string::npos ||
                         path.problem.rfind("start at (", 0) == 0 ||
                         path.problem.rfind("goal at (", 0) == 0;
  ASSERT_EQ(saysWhere, plainIn2D) << path.problem;
}

TEST(RobotPathRandom, isRightOnRandomLayers)
{
  Tally tally;
  for (unsigned seed = 0; seed < 1500 && !HasFatalFailure(); ++seed) checkOnce(seed, tally);
  EXPECT_GT(tally.connected, 500);
  EXPECT_GT(tally.detours, 100);
  EXPECT_GT(tally.onlyIn2D, 100);
  EXPECT_GT(tally.notIn2D, 50);
  EXPECT_LT(tally.luck, 50);
  EXPECT_LT(tally.small, 50);
  RecordProperty("connected", tally.connected);
  RecordProperty("detours", tally.detours);
  RecordProperty("only_in_2d", tally.onlyIn2D);
  RecordProperty("by_luck", tally.luck);
}

}  // namespace
