#pragma once

#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/freespace/Robot.h>

namespace mrpt_mapconv::freespace
{
/** Where a robot may be. */
inline const grid::Layer<float>& occupancyFor(const Layers& layers, Robot robot)
{
  return robot == Robot::Ground ? layers.ground : layers.aerial;
}

/** What the heights of a robot's path are counted from [m]: a ground robot stands on the support,
 * wherever free space begins over it; an aerial one keeps to free space. */
inline const grid::Layer<float>& heightsFor(const Layers& layers, Robot robot)
{
  return robot == Robot::Ground ? layers.support : layers.floor;
}

}  // namespace mrpt_mapconv::freespace
