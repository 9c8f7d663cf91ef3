// planRobotPath on rooms whose ways are worked out by hand.
#include <gtest/gtest.h>
#include <mrpt_mapconv/planning/RobotPath.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/HandMap.h"
#include "support/SeenGround.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::planning;

constexpr double kRadius = 0.3;
const freespace::ConversionParams kConversion;  // minClearance 1 m

struct CellRect
{
  int xMin, yMin, xEnd, yEnd;
};

void setRange(freespace::Layers& layers, const CellRect& rect, float floor, float ceiling)
{
  for (int y = rect.yMin; y < rect.yEnd; ++y)
    for (int x = rect.xMin; x < rect.xEnd; ++x)
    {
      layers.floor.at(x, y) = floor;
      layers.ceiling.at(x, y) = ceiling;
      layers.aerial.at(x, y) = layers.ground.at(x, y) = std::isnan(floor) ? 1.0f : 0.0f;
    }
}

/** A room of 6 m × rows·0.1 m within walls of one cell, 1.7 m high. */
freespace::Layers room(int rows)
{
  freespace::Layers layers(grid::GridFrame{0.1, 0, 0, 60, rows});
  setRange(layers, {0, 0, 60, rows}, freespace::Layers::kNone, freespace::Layers::kNone);
  setRange(layers, {1, 1, 59, rows - 1}, 0, 1.7f);
  return layers;
}

/** In the room's middle a block up to y = 1 m whose free range is 1.5 … 2.5 m high: the sphere fits
 * in on either side of its border, but not across. A centre row must be more than 0.3 m from the
 * block, so at y = 1.35 m at the lowest, and at least three cells from the wall in the last row.
 * With 18 rows that leaves one row of cells, with 17 none. */
freespace::Layers roomWithBlock(int rows)
{
  freespace::Layers layers = room(rows);
  setRange(layers, {28, 1, 32, 10}, 1.5f, 2.5f);
  return layers;
}

RobotPathQuery acrossRoom(double y)
{
  RobotPathQuery query;
  query.start = {1.05, y};
  query.goal = {5.05, y};
  query.robotRadius = query.lift.safetyRadius = kRadius;
  query.lift.heightOffset = 0.5;
  return query;
}

RobotPath plan(const freespace::Layers& layers, const RobotPathQuery& query)
{
  return planRobotPath(test::withSeenGround(layers), kConversion, query);
}

TEST(RobotPath, straightWayIsLiftedAsItIs)
{
  const auto path = plan(room(18), acrossRoom(0.55));
  ASSERT_TRUE(path.found()) << path.problem;
  EXPECT_TRUE(path.path.feasible());
  EXPECT_NEAR(path.path.length2D(), 4, 1e-9);
  EXPECT_EQ(path.path.points.size(), 41u);
  for (const auto& point : path.path.points) EXPECT_NEAR(point.position.z, 0.5, 1e-6);
}

TEST(RobotPath, goesAroundWhatNoHeightFits)
{
  const auto path = plan(roomWithBlock(18), acrossRoom(0.55));
  ASSERT_TRUE(path.found()) << path.problem;
  EXPECT_TRUE(path.path.feasible());
  int beside = 0;
  for (const auto& point : path.path.points)
  {
    EXPECT_NEAR(point.position.z, 0.5, 1e-6) << "never over the block";
    if (point.position.x < 2.8 || point.position.x > 3.2) continue;
    ++beside;
    EXPECT_GE(point.position.y, 1.3);
    EXPECT_LE(point.position.y, 1.4);
  }
  EXPECT_GE(beside, 3);
  // straight to the block's corners and back would be 4.23 m
  EXPECT_GT(path.path.length2D(), 4.2);
  EXPECT_LT(path.path.length2D(), 5);
}

TEST(RobotPath, saysWhatBlocksTheOnlyWay)
{
  const auto path = plan(roomWithBlock(17), acrossRoom(0.55));
  ASSERT_FALSE(path.found());
  EXPECT_TRUE(path.path.points.empty());
  EXPECT_EQ(path.path.length2D(), 0);
  // at x = 2.45 m, 0.35 m before the block, it fits still; half a metre further it does not
  EXPECT_EQ(path.problem,
            "there is a way in 2D, but not in 3D: at (2.55, 0.55): the safety sphere fits in at no "
            "height");
}

TEST(RobotPath, leavesOutALowLintelIfThereIsAnotherDoor)
{
  // a wall with two doors; before the lower one, whose lintel is at 1 m, a sill of 0.5 m: over the
  // sill the sphere's centre is at 0.8 m or higher, below the lintel at 0.7 m or lower; 0.25 m
  // before the lintel it still fits in at 1 − sqrt(0.3² − 0.25²) = 0.83 m, 0.15 m before it only at
  // 0.74 m
  freespace::Layers layers = room(40);
  setRange(layers, {30, 1, 32, 39}, freespace::Layers::kNone, freespace::Layers::kNone);
  setRange(layers, {30, 2, 32, 13}, 0, 1.0f);
  setRange(layers, {28, 2, 30, 13}, 0.5f, 1.7f);
  auto query = acrossRoom(0.75);
  const auto closed = plan(layers, query);
  ASSERT_FALSE(closed.found());
  EXPECT_NE(closed.problem.find("not in 3D: at (2.85, 0.75): the safety sphere fits in at no"),
            std::string::npos)
      << closed.problem;

  setRange(layers, {30, 26, 32, 37}, 0, 1.7f);
  const auto path = plan(layers, query);
  ASSERT_TRUE(path.found()) << path.problem;
  EXPECT_TRUE(path.path.feasible());
  for (const auto& point : path.path.points)
    if (std::abs(point.position.x - 3.1) < 0.1)
    {
      EXPECT_GT(point.position.y, 2.8);
    }
}

TEST(RobotPath, saysIfTheRobotDoesNotFitAtAnEnd)
{
  auto query = acrossRoom(0.55);
  query.start.x = 2.65;
  EXPECT_EQ(plan(roomWithBlock(18), query).problem,
            "start at (2.65, 0.55): the safety sphere fits in at no height");
  std::swap(query.start, query.goal);
  EXPECT_EQ(plan(roomWithBlock(18), query).problem,
            "goal at (2.65, 0.55): the safety sphere fits in at no height");
  // 0.29 m from the block it fits, 0.25 m from it not
  query.lift.safetyRadius = 0.27;
  query.goal.x = 2.51;
  EXPECT_EQ(plan(roomWithBlock(18), query).problem,
            "goal: the centre of its cell, at (2.55, 0.55): the safety sphere fits in at no "
            "height");
}

TEST(RobotPath, placesInWordsHaveTheOriginThatIsShown)
{
  auto query = acrossRoom(0.55);
  query.lift.shownOrigin = {448258, 5411929, 200};
  query.start = {-1, 0.5};
  EXPECT_EQ(
      plan(roomWithBlock(18), query)
          .problem.rfind("start (448257, 5411929.5) m is outside the map, which covers x from "
                         "448258 to 448",
                         0),
      0u)
      << plan(roomWithBlock(18), query).problem;
  query.start = {2.65, 0.55};
  EXPECT_EQ(plan(roomWithBlock(18), query).problem,
            "start at (448260.65, 5411929.55): the safety sphere fits in at no height");
}

TEST(RobotPath, leavesToTheGridPlannerWhatIsKnownIn2D)
{
  auto query = acrossRoom(0.55);
  query.start = {-1, 0.5};
  EXPECT_EQ(plan(roomWithBlock(18), query).problem.rfind("start (-1, 0.5) m is outside the map", 0),
            0u);
  query = acrossRoom(0.55);
  query.goal = {5.05, 0.25};
  EXPECT_NE(plan(roomWithBlock(18), query).problem.find("too near to an obstacle"),
            std::string::npos);
  auto walled = room(18);
  setRange(walled, {30, 1, 31, 17}, freespace::Layers::kNone, freespace::Layers::kNone);
  EXPECT_NE(plan(walled, acrossRoom(0.55)).problem.find("are not connected"), std::string::npos);
}

TEST(RobotPath, groundRobotIsStoppedByNoCeiling)
{
  auto layers = room(18);
  setRange(layers, {28, 1, 32, 17}, 0, 0.4f);
  auto query = acrossRoom(0.55);
  query.lift.robot = freespace::Robot::Ground;
  query.lift.heightOffset = 0;
  const auto path = plan(layers, query);
  ASSERT_TRUE(path.found()) << path.problem;
  EXPECT_NEAR(path.path.length2D(), 4, 1e-9);
}

TEST(RobotPath, groundRobotGoesAroundPlacesWithoutFloor)
{
  auto layers = room(18);
  for (int y = 1; y < 10; ++y) layers.floor.at(30, y) = freespace::Layers::kNone;
  auto query = acrossRoom(0.55);
  query.lift.robot = freespace::Robot::Ground;
  const auto path = plan(layers, query);
  ASSERT_TRUE(path.found()) << path.problem;
  for (const auto& point : path.path.points)
    if (point.position.x > 3.0 && point.position.x < 3.1)
    {
      EXPECT_GE(point.position.y, 1.0);
    }

  for (int y = 10; y < 17; ++y) layers.floor.at(30, y) = freespace::Layers::kNone;
  EXPECT_EQ(plan(layers, query).problem,
            "there is a way in 2D, but not in 3D: at (3.05, 0.55): no floor there");
}

/** 6 m × 3 m, 3 m high, with a slab from 1.5 to 1.6 m over x = 2 … 4 m and `rows` rows of cells;
 * from x = 3 m on, the floor is 0.2 m higher. At 1.4 m above the floor the sphere goes below the
 * slab at x < 3 m (1.2 m high, 0.2 m too low) and above it (1.9 m, 0.3 m too high) from there on.
 */
class SlabMap : public test::HandMap
{
 public:
  explicit SlabMap(int rows) : HandMap(0.1)
  {
    for (int kx = 0; kx < 60; ++kx)
      for (int ky = 0; ky < 30; ++ky)
      {
        free(kx, ky, kx < 30 ? 0 : 2, 30);
        if (kx >= 20 && kx < 40 && ky < rows) occupied(kx, ky, 15, 16);
      }
  }
  RobotPath plan() const
  {
    auto query = acrossRoom(0.75);
    query.lift.heightOffset = 1.4;
    query.lift.lookahead = 0;
    return planRobotPath(convert(kConversion), kConversion, query, &source());
  }
};

TEST(RobotPath, climbsThroughNoSlab)
{
  const auto path = SlabMap(15).plan();
  ASSERT_TRUE(path.found()) << path.problem;
  const auto& points = path.path.points;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    // beside the slab the floor's step is the highest; along its edge the sphere gives way to it
    const auto &from = points[i - 1].position, &to = points[i].position;
    EXPECT_FALSE(std::min(from.z, to.z) < 1.5 && std::max(from.z, to.z) > 1.6 &&
                 std::max(from.y, to.y) < 1.5 && from.x > 2 && to.x < 4)
        << from << " to " << to;
  }
  EXPECT_GT(path.path.length2D(), 4);
}

TEST(RobotPath, saysWhereASlabIsInTheWayOfAClimb)
{
  const auto path = SlabMap(30).plan();
  ASSERT_FALSE(path.found());
  EXPECT_NE(path.problem.find("at (3.05, 0.75): something is in the way between the heights of "
                              "1.20 m and 1.90 m"),
            std::string::npos)
      << path.problem;
  EXPECT_EQ(path.problem.find("not in 3D"), std::string::npos) << "more than is known";
}

TEST(RobotPath, doesNotClaimThatThereIsNoneWhenItGivesUp)
{
  auto query = acrossRoom(0.55);
  query.mostAttempts = 1;
  EXPECT_EQ(plan(roomWithBlock(18), query).problem,
            "no path in 3D among the first 1 that were tried, there may be another; what was wrong "
            "with the first, at (2.55, 0.55): the safety sphere fits in at no height");
  query.mostAttempts = 0;
  EXPECT_THROW(plan(roomWithBlock(18), query), std::invalid_argument);
}

}  // namespace
