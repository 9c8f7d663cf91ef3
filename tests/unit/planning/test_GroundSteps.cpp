// planRobotPath of a ground robot over floors with steps.
#include <gtest/gtest.h>
#include <mrpt_mapconv/path/PieceCheck.h>
#include <mrpt_mapconv/planning/RobotPath.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "../../oracle/PieceOracle.h"
#include "support/SeenGround.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::planning;

constexpr double kCell = 0.1;

/** Free cells with floors of so many voxels, 3 m high, the highest y first. */
freespace::Layers floors(const std::vector<std::string>& rows)
{
  const auto width = static_cast<std::int32_t>(rows.front().size());
  const auto height = static_cast<std::int32_t>(rows.size());
  freespace::Layers layers(grid::GridFrame{kCell, 0, 0, width, height});
  for (std::int32_t iy = 0; iy < height; ++iy)
    for (std::int32_t ix = 0; ix < width; ++ix)
    {
      const int voxels =
          rows[static_cast<std::size_t>(height - 1 - iy)][static_cast<std::size_t>(ix)] - '0';
      layers.floor.at(ix, iy) = static_cast<float>(voxels * kCell);
      layers.ceiling.at(ix, iy) = 3;
      layers.slope.at(ix, iy) = 0;
      layers.aerial.at(ix, iy) = layers.ground.at(ix, iy) = 0;
    }
  return test::withSeenGround(layers);
}

RobotPathQuery query(int fromX, int fromY, int toX, int toY)
{
  RobotPathQuery query;
  query.start = {(fromX + 0.5) * kCell, (fromY + 0.5) * kCell};
  query.goal = {(toX + 0.5) * kCell, (toY + 0.5) * kCell};
  query.robotRadius = 0;
  query.lift.robot = freespace::Robot::Ground;
  query.lift.heightOffset = 0;
  return query;
}

TEST(GroundSteps, AFenceIsGoneAround)
{
  const auto layers = floors({"00000000000", "00000900000", "00000900000", "00000900000"});
  const auto path = planRobotPath(layers, {}, query(1, 0, 9, 0));
  ASSERT_TRUE(path.found()) << path.problem;
  for (const auto& point : path.path.points) EXPECT_EQ(0, point.position.z);
  EXPECT_GT(path.path.length(), 0.9);
}

TEST(GroundSteps, AClosedFenceIsNamedWithPlaceAndHeights)
{
  const auto layers = floors({"00000900000", "00000900000", "00000900000"});
  EXPECT_EQ(planRobotPath(layers, {}, query(1, 1, 9, 1)).problem,
            "there is a way in 2D, but not in 3D: at (0.55, 0.15): the floor rises from 0.00 m to "
            "0.90 m within 0.10 m, more than a ground robot can, max(maxStep, a voxel, maxSlope x "
            "distance) = 0.20 m");
}

TEST(GroundSteps, ADitchNarrowerThanTheLookaheadIsGoneAround)
{
  const auto layers = floors({"99999999999", "99999099999", "99999099999"});
  const auto path = planRobotPath(layers, {}, query(1, 0, 9, 0));
  ASSERT_TRUE(path.found()) << path.problem;
  EXPECT_GT(path.path.length2D(), 0.85);
  const auto closed = floors({"99999099999", "99999099999", "99999099999"});
  EXPECT_NE(
      planRobotPath(closed, {}, query(1, 0, 9, 0)).problem.find("the floor drops from 0.90 m"),
      std::string::npos);
}

TEST(GroundSteps, TheStepThatIsNamedIsOneThatCannotBeGoneAround)
{
  // the first one can be
  const auto layers = floors({"00000000900", "00090000900", "00090000900"});
  const auto path = planRobotPath(layers, {}, query(0, 0, 10, 0));
  EXPECT_NE(path.problem.find("at (0.85, "), std::string::npos) << path.problem;
}

TEST(GroundSteps, MaxStepMaxSlopeAndAVoxelAreAllowed)
{
  const auto passes = [](const std::string& row, double maxStep, double maxSlope)
  {
    freespace::ConversionParams conversion;
    conversion.maxStep = maxStep;
    conversion.maxSlope = maxSlope;
    return planRobotPath(floors({row, row}), conversion, query(0, 0, 5, 0)).found();
  };
  EXPECT_TRUE(passes("000111", 0, 0));
  EXPECT_FALSE(passes("000222", 0, 1.9));
  EXPECT_TRUE(passes("000222", 0, 2));
  EXPECT_TRUE(passes("000222", 0.2, 0));
  EXPECT_FALSE(passes("000333", 0.2, 2));
  EXPECT_TRUE(passes("000333", 0.3, 0));
  EXPECT_TRUE(passes("333000", 0.3, 0));
  EXPECT_TRUE(passes("024682", 0.6, 2));
}

TEST(GroundSteps, TheStartSaysWhyItIsNotFree)
{
  auto layers = floors({"000000", "000000"});
  layers.ground.at(1, 0) = 1;
  layers.slope.at(1, 0) = 2.5f;
  freespace::ConversionParams conversion;
  const auto problem = [&] { return planRobotPath(layers, conversion, query(1, 0, 5, 0)).problem; };
  EXPECT_EQ(
      problem(),
      "start (0.15, 0.05) m is in an occupied cell: the slope there, 2.5, is above maxSlope = "
      "2");
  layers.slope.at(1, 0) = 1;
  conversion.maxStep = 0.1;
  EXPECT_EQ(problem(),
            "start (0.15, 0.05) m is in an occupied cell: the step to a cell beside it is above "
            "maxStep = 0.1 m");
  layers.aerial.at(1, 0) = 1;
  EXPECT_EQ(
      problem(),
      "start (0.15, 0.05) m is in an occupied cell: no free range there is minClearance = 1 m "
      "high");
  layers.aerial.at(1, 0) = layers.ground.at(1, 0) = -1;
  EXPECT_EQ(problem(),
            "start (0.15, 0.05) m is in an unknown cell: no free range is known there that is "
            "minClearance = 1 m high");
}

int pick(std::mt19937& rng, int low, int high)
{
  return low + static_cast<int>(rng() % static_cast<unsigned>(high - low + 1));
}

/** Patches of floor, each a little higher or lower than the one it lies on, and some walls. */
freespace::Layers randomFloors(std::mt19937& rng)
{
  const int width = pick(rng, 4, 24), height = pick(rng, 4, 24);
  auto layers = floors(std::vector<std::string>(static_cast<std::size_t>(height),
                                                std::string(static_cast<std::size_t>(width), '5')));
  for (int patch = pick(rng, 3, 25); patch > 0; --patch)
  {
    const int x = pick(rng, 0, width - 1), y = pick(rng, 0, height - 1);
    const int change = pick(rng, -2, 3);
    const bool wall = pick(rng, 0, 9) == 0;
    for (int iy = y, yEnd = std::min(height, y + pick(rng, 1, 12)); iy < yEnd; ++iy)
      for (int ix = x, xEnd = std::min(width, x + pick(rng, 1, 12)); ix < xEnd; ++ix)
      {
        layers.floor.at(ix, iy) += static_cast<float>(change * kCell);
        if (wall) layers.ground.at(ix, iy) = 1;
      }
  }
  return test::withSeenGround(layers);
}

/** Whether steps that are low enough lead from cell to cell. */
bool connected(const freespace::Layers& layers, const oracle::PieceOracle& steps, int fromX,
               int fromY, int toX, int toY)
{
  const auto& frame = layers.frame();
  grid::Layer<char> reached(frame, 0);
  reached.at(fromX, fromY) = 1;
  for (bool more = true; more;)
  {
    more = false;
    for (int iy = 0; iy < frame.height; ++iy)
      for (int ix = 0; ix < frame.width; ++ix)
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        {
          const int x = ix + dx, y = iy + dy;
          if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) continue;
          if (!reached.at(ix, iy) || reached.at(x, y) || layers.ground.at(x, y) != 0) continue;
          if (steps.stepTooHigh(static_cast<double>(layers.floor.at(ix, iy)),
                                static_cast<double>(layers.floor.at(x, y)), kCell))
            continue;
          reached.at(x, y) = 1;
          more = true;
        }
  }
  return reached.at(toX, toY) != 0;
}

TEST(GroundSteps, ThereIsAPathIfAndOnlyIfLowStepsLeadToTheGoal)
{
  int paths = 0, none = 0, winding = 0;
  for (unsigned seed = 0; seed < 1500 && !HasFatalFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 rng(seed);
    const auto layers = randomFloors(rng);
    freespace::ConversionParams conversion;
    conversion.maxSlope = 0.5 * pick(rng, 0, 4);
    conversion.maxStep = 0.1 * pick(rng, 0, 2);
    const auto& frame = layers.frame();
    const auto cell = [&] {
      return std::pair{pick(rng, 0, frame.width - 1), pick(rng, 0, frame.height - 1)};
    };
    const auto from = cell(), to = cell();
    auto task = query(from.first, from.second, to.first, to.second);
    const auto aside = [&] { return 0.001 * pick(rng, -49, 49); };  // anywhere in the cell
    task.start += {aside(), aside()};
    task.goal += {aside(), aside()};
    task.lift.lookahead = 0.05 * pick(rng, 0, 12);
    if (layers.ground.at(from.first, from.second) != 0 ||
        layers.ground.at(to.first, to.second) != 0)
      continue;

    oracle::DenseMap voxels;
    voxels.resolution = kCell;
    const oracle::PieceOracle rule(voxels, conversion, freespace::Robot::Ground, 0);
    const auto path = planRobotPath(layers, conversion, task);
    ASSERT_EQ(path.found(), connected(layers, rule, from.first, from.second, to.first, to.second))
        << path.problem;
    ++(path.found() ? paths : none);
    for (std::size_t i = 1; i < path.path.points.size(); ++i)
    {
      const auto &a = path.path.points[i - 1].position, &b = path.path.points[i].position;
      ASSERT_FALSE(rule.stepTooHigh(a.z, b.z, std::hypot(b.x - a.x, b.y - a.y)))
          << a << " to " << b;
    }
    winding += path.found() && path.path.length2D() > 1.5 * std::hypot(task.goal.x - task.start.x,
                                                                       task.goal.y - task.start.y);
    ASSERT_TRUE(path.found() || path.problem.find("not connected") != std::string::npos ||
                path.problem.find("at (") != std::string::npos)
        << path.problem;
  }
  EXPECT_GT(paths, 300);
  EXPECT_GT(none, 200);
  EXPECT_GT(winding, 20);
}

TEST(GroundSteps, StepsAreThoseOfTheSupportNotOfTheFloor)
{
  auto layers = floors({"00000000", "00000000"});
  for (int iy = 0; iy < 2; ++iy)
  {
    layers.floor.at(4, iy) = 0.9f;  // free space begins there, over the ground
    layers.evidence.at(4, iy) = freespace::evidence::kInferred;
  }
  const auto over = planRobotPath(layers, {}, query(1, 0, 6, 0));
  ASSERT_TRUE(over.found()) << over.problem;
  for (const auto& point : over.path.points) EXPECT_EQ(0, point.position.z);
  EXPECT_NEAR(over.path.inferredLength, kCell, 1e-9);

  layers = floors({"00000000", "00000000"});
  for (int iy = 0; iy < 2; ++iy) layers.support.at(4, iy) = -0.9f;
  EXPECT_NE(
      planRobotPath(layers, {}, query(1, 0, 6, 0)).problem.find("the floor drops from 0.00 m"),
      std::string::npos);
}

TEST(GroundSteps, AnEndWithoutGroundSaysSo)
{
  auto layers = floors({"000000", "000000"});
  layers.ground.at(1, 0) = grid::kUnknown;
  layers.support.at(1, 0) = layers.slope.at(1, 0) = freespace::Layers::kNone;
  EXPECT_EQ(planRobotPath(layers, {}, query(1, 0, 5, 0)).problem,
            "start (0.15, 0.05) m is in an unknown cell: nobody saw the ground there, and none "
            "that was seen around tells where it is");
}

TEST(GroundSteps, AnEndOnTheEdgeOfADropSaysSo)
{
  auto layers = floors({"000000", "000000"});
  layers.ground.at(1, 0) = 1;
  for (int ix = 2; ix < 4; ++ix) layers.support.at(ix, 0) = freespace::Layers::kNone;
  layers.floor.at(3, 0) = -0.5f;
  freespace::ConversionParams conversion;
  conversion.maxStep = 0.2;
  conversion.floorFrom = freespace::FloorFrom::Seen;
  EXPECT_EQ(planRobotPath(layers, conversion, query(1, 0, 5, 0)).problem,
            "start (0.15, 0.05) m is in an occupied cell: it is the edge of a drop: within 1 m the "
            "floor lies lower by more than maxStep = 0.2 m and a voxel");
  layers.floor.at(3, 0) = -0.3f;
  EXPECT_NE(planRobotPath(layers, conversion, query(1, 0, 5, 0)).problem.find("the step to a cell"),
            std::string::npos);
}

}  // namespace
