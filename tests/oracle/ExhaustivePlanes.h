#pragma once

#include <cstddef>
#include <map>

#include "TerrainOracle.h"

namespace mrpt_mapconv::oracle
{
using TerrainHeights = std::map<TerrainKey, double>;  // [m]

/** Planes of few cells by trying all planes through three of them: each cell belongs to the largest
 * connected set of cells that lie on one plane with it. \param tolerance [m] */
TerrainLabels exhaustivePlanes(const TerrainHeights& heights, double tolerance,
                               std::size_t minCells);

}  // namespace mrpt_mapconv::oracle
