// From a simulated exploration to paths in 3D: none touches the world that was explored.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/planning/RobotPath.h>
#include <mrpt_mapconv/sim/Simulator.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/octomap.h>

#include <cmath>
#include <random>

#include "RoomFixtures.h"

namespace
{
using namespace mrpt_mapconv;
using mrpt::math::TPoint3D;
using sim::fixtures::kRoom;

constexpr double kResolution = 0.1;
constexpr double kSafetyRadius = 0.4;
constexpr double kRobotRadius = kSafetyRadius - kResolution;

/** The fixtures' room, cut in two by a wall with a doorway under a lintel; a table and a low wall
 * on one side, a hanging beam on the other. */
const std::string kFurniture = R"(
[box.wall_south]
min = -0.1 -4 0
max = 0.1 -0.6 3
[box.wall_north]
min = -0.1 1 0
max = 0.1 4 3
[box.lintel]
min = -0.1 -0.6 2
max = 0.1 1 3
[box.table_top]
min = -3.5 1.2 0.7
max = -2 2.4 0.75
[box.table_leg]
min = -2.8 1.7 0
max = -2.6 1.9 0.7
[box.low_wall]
min = -4.9 -1.3 0
max = -1.6 -1.1 0.6
[box.beam]
min = 2.4 -4 1.6
max = 2.7 4 1.9
)";

const std::string kTour = R"(
[trajectory]
waypoints = [-3.9 0 1.2] [-1.3 -0.2 1.2] [-1.2 -2.6 1.2] [-3.9 -2.6 1.2] [-1.2 -2.6 1.2] [-1.2 3.1 1.2] [-4 3.1 1.2] [-1.2 3.1 1.2] [-1 0.2 1.2] [1.3 0.2 1.2] [1.3 2.9 1.2] [3.8 2.9 1] [3.8 -2.9 1] [1.3 -2.9 1.2]
speed = 1
turnRate = 180
[sensor.lidar]
kind = lidar
pose = 0 0 0  0 0 0
beams = 40
elevationMin = -88
elevationMax = 88
azimuthSteps = 240
rate = 1
maxRange = 12
)";

octomap::OcTree explored(const sim::Scenario& scenario)
{
  octomap::OcTree tree(kResolution);
  sim::Simulator simulator(scenario, 1);
  std::vector<observation::PosedObservation> scans;
  while (const auto moment = simulator.next())
    for (const sim::Scan& scan : moment->scans) scans.push_back({scan.observation, moment->pose});
  voxel::insertScans(tree, scans, {});
  return tree;
}

/** A free cell's centre. */
mrpt::math::TPoint2D somewhere(const freespace::Layers& layers, std::mt19937& rng)
{
  const auto& frame = layers.frame();
  for (;;)
  {
    const auto x = static_cast<int>(rng() % static_cast<unsigned>(frame.width));
    const auto y = static_cast<int>(rng() % static_cast<unsigned>(frame.height));
    if (grid::isFree(layers.aerial.at(x, y)))
      return {(frame.x0 + x + 0.5) * kResolution, (frame.y0 + y + 0.5) * kResolution};
  }
}

/** Flies a path. \return places looked at, at most 1 cm apart */
int fly(const sim::World& world, const path::LiftedPath& path)
{
  constexpr double kStep = 0.01, kLines = 0.02;  // [m]
  int places = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i)
  {
    const TPoint3D from = path.points[i - 1].position, along = path.points[i].position - from;
    const int pieces = 1 + static_cast<int>(along.norm() / kStep);
    for (int k = 0; k <= pieces; ++k, ++places)
    {
      const TPoint3D at = from + along * (static_cast<double>(k) / pieces);
      EXPECT_FALSE(world.sphereHits(at, kRobotRadius, kLines)) << at;
      if (::testing::Test::HasFailure()) return places;
    }
  }
  return places;
}

TEST(FlownPaths, NoneTouchesTheWorld)
{
  const auto scenario = sim::fixtures::load(kRoom + kFurniture + kTour);
  const octomap::OcTree tree = explored(scenario);
  const voxel::OctreeSource<octomap::OcTree> voxels(tree);
  const auto conversion = freespace::ConversionParams::paper();
  const auto layers = freespace::convert(voxels, conversion);

  constexpr unsigned kSeed = 5;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 rng(kSeed);
  int found = 0, throughDoor = 0, moved = 0, places = 0;
  for (int pair = 0; pair < 40 && !HasFailure(); ++pair)
  {
    planning::RobotPathQuery query;
    query.start = somewhere(layers, rng);
    query.goal = somewhere(layers, rng);
    query.robotRadius = query.lift.safetyRadius = kSafetyRadius;
    query.lift.heightOffset = pair % 2 == 0 ? 0.5 : 1.7;  // into the low wall, into the beam
    const auto path = planning::planRobotPath(layers, conversion, query, &voxels);
    if (!path.found()) continue;
    SCOPED_TRACE("pair " + std::to_string(pair));
    ++found;
    throughDoor += query.start.x * query.goal.x < 0;
    for (const auto& point : path.path.points)
      moved += point.rule == path::HeightRule::SphereSlab ||
               point.rule == path::HeightRule::SphereCeiling;
    places += fly(scenario.world, path.path);
  }
  EXPECT_GT(found, 10);
  EXPECT_GT(throughDoor, 3);
  EXPECT_GT(moved, 20) << "nothing was in the way";
  EXPECT_GT(places, 2000);
  RecordProperty("found", found);
  RecordProperty("through_door", throughDoor);
  RecordProperty("points_moved", moved);
  RecordProperty("places", places);
}

}  // namespace
