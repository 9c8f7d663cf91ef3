// Ground robots on ground that is inferred beside things that the ground layer does not show.
#include <gtest/gtest.h>
#include <mrpt_mapconv/planning/RobotPath.h>

#include <string>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::planning;

/** 2 m × 1.5 m of 0.1 m, 3 m high; of the columns at x = 1 m nobody saw the ground. In those with
 * y < 0.6 m stands something whose top nobody saw either: free space begins above it. */
class Room : public test::HandMap
{
 public:
  /** \param unseen columns at x = 1 m from 1 m below the ground on, see HandMap::column() */
  explicit Room(const std::string& unseen, int rows = 6) : HandMap(0.1)
  {
    params.floorFrom = freespace::FloorFrom::Seen;
    params.maxStep = 0.2;
    for (int ky = 0; ky < 15; ++ky)
      for (int kx = 0; kx < 20; ++kx)
        column(kx, ky, -10,
               kx != 10    ? ".........#" + std::string(30, 'f')
               : ky < rows ? unseen
                           : "...........f" + std::string(28, 'f'));
  }

  RobotPath plan(double radius = 0, double goalX = 1.55) const
  {
    RobotPathQuery query;
    query.start = {0.45, 0.35};
    query.goal = {goalX, 0.35};
    query.robotRadius = radius;
    query.lift.robot = freespace::Robot::Ground;
    query.lift.heightOffset = 0;
    const auto layers = convert(params);
    return planRobotPath(layers, params, query, &source());
  }

  freespace::ConversionParams params;
};

// free from −0.1 to 0.9 m, as high as it must be, under something occupied; the ground is at 0 m
const std::string kLow = ".........ffffffffff#" + std::string(20, 'f');
const std::string kBlock = "..............####..." + std::string(19, 'f');  // 0.4 to 0.8 m

TEST(InferredObstacles, WhatStandsBelowTheFreeSpaceIsGoneAround)
{
  for (const double radius : {0.0, 0.2})
  {
    const RobotPath way = Room(kBlock).plan(radius);
    ASSERT_TRUE(way.found()) << way.problem;
    for (const auto& point : way.path.points)
      if (point.position.x > 1 - radius && point.position.x < 1.1 + radius)
      {
        EXPECT_GE(point.position.y, 0.6 + radius) << point.position.x;
      }
    EXPECT_GT(way.path.inferredLength, 0.09);
  }
  EXPECT_NE(Room(kBlock, 15).plan().problem.find("are not connected"), std::string::npos);
}

TEST(InferredObstacles, UnknownAndLowThingsAreInNobodysWay)
{
  for (const std::string& unseen :
       {"....................." + std::string(19, 'f'),   // nothing is known up to 1.1 m
        "..........##........." + std::string(19, 'f')})  // the robot climbs 0.2 m
  {
    const RobotPath way = Room(unseen).plan();
    ASSERT_TRUE(way.found()) << unseen << way.problem;
    EXPECT_NEAR(way.path.length2D(), 1.1, 1e-9) << unseen;
  }
}

TEST(InferredObstacles, AGoalUnderWhatHangsLowSaysWhy)
{
  EXPECT_EQ(Room(kLow).plan(0, 1.05).problem,
            "goal (1.05, 0.35) m is in an occupied cell: something occupied is in the robot's way "
            "there, over ground that is inferred");
}

TEST(InferredObstacles, WhatHangsLowOverALineAboveTheFloorIsInTheWay)
{
  const RobotPath way = Room(kLow).plan();
  ASSERT_TRUE(way.found()) << way.problem;
  EXPECT_GT(way.path.length2D(), 1.2);
}

}  // namespace
