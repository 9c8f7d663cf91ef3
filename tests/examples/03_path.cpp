// Example 3: a path for a flying robot, planned in 2D and lifted to 3D.
//
// Two rooms with a wall between them. The wall has one opening, a window from z = 1 to z = 2 m. In
// the layers that is a place of free air like any other, so the way leads through it; lifting gives
// each of its points a height, and over the sill the path rises. The example ends with 1 if it does
// not, or if it finds a way where there is none.
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/planning/RobotPath.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace mrpt_mapconv;

namespace
{
/** 6 x 4 m, 3 m high; a wall at x = 3 m with a window between y = 1 and 2.4 m, if there is one. */
octomap::OcTree twoRooms(bool window)
{
  octomap::OcTree tree(0.1);
  for (int ix = 0; ix < 60; ++ix)
    for (int iy = 0; iy < 40; ++iy)
      for (int iz = -1; iz <= 30; ++iz)
      {
        const bool inWall = ix == 30;
        const bool inWindow = window && iy >= 10 && iy < 24 && iz >= 10 && iz < 20;
        const bool solid = iz == -1 || iz == 30 || (inWall && !inWindow);
        tree.updateNode(0.1 * ix + 0.05, 0.1 * iy + 0.05, 0.1 * iz + 0.05, solid);
      }
  return tree;
}

planning::RobotPath flight(const octomap::OcTree& tree)
{
  const voxel::OctreeSource<octomap::OcTree> source(tree);
  freespace::ConversionParams conversion;
  conversion.minClearance = 0.8;
  const freespace::Layers layers = freespace::convert(source, conversion);

  planning::RobotPathQuery query;
  query.start = {1, 3};
  query.goal = {5, 3};
  query.robotRadius = 0.3;        // for the way in 2D
  query.lift.safetyRadius = 0.3;  // a sphere that must fit in everywhere
  query.lift.heightOffset = 0.6;  // fly this high above the floor, where that is possible
  // With the voxel map, lintels and roofs between two floors are seen, too.
  return planning::planRobotPath(layers, conversion, query, &source);
}
}  // namespace

int main()
{
  const planning::RobotPath found = flight(twoRooms(true));
  if (!found.found())
  {
    std::cerr << found.problem << '\n';
    return 1;
  }
  double lowest = 100, throughWindow = 0;
  for (const path::LiftedPoint& point : found.path.points)
  {
    const auto& [x, y, z] = point.position;
    std::cout << x << ' ' << y << ' ' << z << '\n';
    lowest = std::min(lowest, z);
    if (x > 3 && x < 3.1) throughWindow = z;
  }
  std::cout << found.path.length() << " m long\n";

  const planning::RobotPath none = flight(twoRooms(false));
  std::cout << "without the window: " << none.problem << '\n';

  const bool right = std::abs(lowest - 0.6) < 1e-5 && throughWindow >= 1.3 - 1e-5 &&
                     throughWindow <= 1.7 + 1e-5 && !none.found();
  if (!right) std::cerr << "that is not a way through the window\n";
  return right ? 0 : 1;
}
