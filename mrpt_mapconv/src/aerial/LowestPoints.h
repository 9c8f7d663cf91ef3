#pragma once

#include <mrpt_mapconv/aerial/GroundParams.h>
#include <mrpt_mapconv/grid/Layer.h>

#include "UsedPoints.h"

namespace mrpt_mapconv::aerial
{
/** For each cell of a frame that holds all used points, the height of the one that the rule names
 * [m]; NaN: none. Of equally near ones it is the lowest. */
grid::Layer<float> heightsOfCells(const cloud::PointCloud& cloud, const UsedPoints& used,
                                  const grid::GridFrame& frame,
                                  CollisionRule rule = CollisionRule::Lowest);

}  // namespace mrpt_mapconv::aerial
