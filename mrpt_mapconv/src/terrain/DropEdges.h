#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <vector>

namespace mrpt_mapconv::terrain
{
/** Cells on the edge of a drop whose foot hides behind it: beyond cells that nobody saw, up to 2 m
 * away, the ground lies more than `drop` below where this ground leads. That is its plane, or,
 * without one, the steepest way down that a robot can walk. Of an edge's cells those are in that
 * noise has moved beyond it, too.
 * \param drop [m] \param maxSlope [m/m] \return for each cell of the layers' frame */
std::vector<bool> dropEdges(const TerrainLayers& layers, double drop, double maxSlope);

}  // namespace mrpt_mapconv::terrain
