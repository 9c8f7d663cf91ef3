// findRemedies on rooms whose doors and steps are known.
#include <gtest/gtest.h>
#include <mrpt_mapconv/planning/Remedies.h>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::planning;

/** 6 m × 2 m, 3 m high, with a sill across at x = 3 m and a wall that leaves a door open. */
class Room : public test::HandMap
{
 public:
  Room(int doorRows, int sill) : HandMap(0.1)
  {
    for (int kx = 0; kx < 60; ++kx)
      for (int ky = 0; ky < 20; ++ky)
      {
        const bool across = kx == 30;
        if (across && ky >= doorRows)
          occupied(kx, ky, 0, 30);
        else
          free(kx, ky, across ? sill : 0, 30);
        if (across && ky < doorRows) occupied(kx, ky, 0, sill);
      }
  }
  Remedies remedies(freespace::Robot robot, double radius, double heightOffset = 0,
                    bool withVoxels = true) const
  {
    const voxel::VoxelSource* voxels = withVoxels ? &source() : nullptr;
    RobotPathQuery query;
    query.start = {1.05, 1.05};
    query.goal = {5.05, 1.05};
    query.robotRadius = query.lift.safetyRadius = radius;
    query.lift.robot = robot;
    query.lift.heightOffset = heightOffset;
    const auto conversion = freespace::ConversionParams::paper();
    const auto layers = convert(conversion);
    EXPECT_FALSE(planRobotPath(layers, conversion, query, voxels).found());
    return findRemedies(layers, conversion, query, voxels);
  }
};

TEST(Remedies, ASmallerRadiusWhereTheDoorIsNarrow)
{
  // the door's 7 cells and the map's edge: a row is 3 cells from either at most
  const auto found = Room(7, 0).remedies(freespace::Robot::Ground, 0.4);
  ASSERT_TRUE(found.robotRadius);
  EXPECT_NEAR(*found.robotRadius, 0.3, 1e-9);
  EXPECT_FALSE(found.maxStep);
  EXPECT_FALSE(found.heightOffset);
}

TEST(Remedies, AHigherStepWhereASillIsInTheWay)
{
  const auto found = Room(20, 4).remedies(freespace::Robot::Ground, 0.3);
  EXPECT_FALSE(found.robotRadius);
  ASSERT_TRUE(found.maxStep);
  EXPECT_NEAR(*found.maxStep, 0.4, 1e-9);
}

TEST(Remedies, NoRobotThatIsSmallerThanHalfACell)
{
  // a row of 2 cells: only a robot without extent fits in
  for (const auto robot : {freespace::Robot::Ground, freespace::Robot::Aerial})
    EXPECT_FALSE(Room(2, 0).remedies(robot, 0.3, 1).robotRadius);
}

TEST(Remedies, WithoutAVoxelMapNothingIsKnownOfAHigherStep)
{
  const auto ground = Room(20, 4).remedies(freespace::Robot::Ground, 0.3, 0, false);
  EXPECT_FALSE(ground.maxStep);
  EXPECT_TRUE(ground.maxStepUnknown);
  EXPECT_FALSE(Room(20, 4).remedies(freespace::Robot::Ground, 0.3).maxStepUnknown);
  EXPECT_FALSE(Room(0, 0).remedies(freespace::Robot::Aerial, 0.3, 0.5, false).maxStepUnknown);
}

TEST(Remedies, NoStepAsHighAsTheRobot)
{
  const auto found = Room(20, 12).remedies(freespace::Robot::Ground, 0.3);
  EXPECT_FALSE(found.maxStep);
}

TEST(Remedies, NothingWhereThereIsNoWay)
{
  const auto found = Room(0, 0).remedies(freespace::Robot::Aerial, 0.3, 0.5);
  EXPECT_FALSE(found.robotRadius || found.heightOffset || found.maxStep);
}

}  // namespace
