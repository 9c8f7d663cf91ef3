#pragma once

#include <mrpt_mapconv/eval/ElevationMap.h>

#include "ElevationUpdate.h"

namespace mrpt_mapconv::eval
{
/** Fills the layers of `fused`, which lie on a common frame within that of the cells. */
void fuseElevation(const grid::Layer<ElevationMap::Cell>& cells, const VarianceLimits& limits,
                   FusedElevation& fused);

}  // namespace mrpt_mapconv::eval
