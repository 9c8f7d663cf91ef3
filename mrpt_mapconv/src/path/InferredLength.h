#pragma once

#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <vector>

namespace mrpt_mapconv::path
{
/** How much of a path lies, horizontally, in cells whose ground is inferred: the sum over the parts
 * of its straight pieces [m]. A way along the border of two cells is in the one that also holds its
 * points; what lies off the map counts as nothing. */
double inferredLength(const std::vector<LiftedPoint>& points, const freespace::Layers& layers);

}  // namespace mrpt_mapconv::path
