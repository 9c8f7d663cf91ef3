#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/planning/RobotPath.h>
#include <mrpt_mapconv/sim/World.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiment/freespace/FreespaceMaps.h"
#include "experiment/freespace/PathPairs.h"

namespace mapconv
{
/** A method's way between two places [m]; empty if it finds none. */
using Way = std::vector<mrpt::math::TPoint3D>;

/** Whether something holds anywhere along a way, looked at in steps of at most `step` [m]. */
template <class Predicate>
bool anyAlong(const Way& way, double step, const Predicate& holds)
{
  if (!way.empty() && holds(way.front())) return true;
  for (std::size_t i = 1; i < way.size(); ++i)
  {
    const auto along = way[i] - way[i - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(along.norm() / step)));
    for (int k = 1; k <= pieces; ++k)
      if (holds(way[i - 1] + along * (static_cast<double>(k) / pieces))) return true;
  }
  return false;
}

/** A planned path's points. */
Way wayOf(const mrpt_mapconv::planning::RobotPath& path);

/** A ground robot's path on one of its maps.
 * \param voxels that the map was made of */
mrpt_mapconv::planning::RobotPath planGround(const GroundMap& map, const FreespaceWorld& world,
                                             const Pair& pair,
                                             const mrpt_mapconv::voxel::VoxelSource& voxels);

/** Whether a way leaves the free cells of a layer, looked at every 2 cm. */
bool leavesFree(const Way& way, const mrpt_mapconv::grid::Layer<float>& truth);

/** Whether a sphere along a way touches the world, tried every 5 cm by vertical lines every 1 cm.
 * \param radius [m] */
bool touches(const Way& way, double radius, const mrpt_mapconv::sim::World& world);

}  // namespace mapconv
