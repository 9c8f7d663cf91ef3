#pragma once

#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include "Densify.h"

namespace mrpt_mapconv::path
{
/** Gives the points of a path their heights by eq. 9, without the sphere; those that have no floor,
 * or no support if the robot is on the ground, get their problem. */
void setFloorHeights(DensePath& dense, const freespace::Layers& layers, const LiftParams& params);

}  // namespace mrpt_mapconv::path
