#pragma once

#include "Cloth.h"

namespace mrpt_mapconv::aerial
{
/** Fixes a settled cloth to ground that it is too stiff to reach: hilltops, edges of steps, steep
 * slopes below a canopy.
 *
 * It spreads from cells where the cloth has met the surface to those within smoothingReach, if the
 * gap between cloth and surface differs by at most smoothingSlope times their distance. Since gaps
 * are compared, not heights, a steep slope is no obstacle where the cloth follows it roughly; a
 * wall and a crown are. (The published post-processing compares heights of adjacent particles,
 * which climbs low roofs and cannot pass the leaves between two ground points.)
 *
 * A cell that was filled stands for the nearest one that has a point, and the cloth is fixed only
 * to such.
 * \param measured heights before empty cells were filled */
void drawOn(Cloth& cloth, const grid::Layer<float>& measured, const GroundParams& params,
            int threads);

}  // namespace mrpt_mapconv::aerial
