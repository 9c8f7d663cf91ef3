#pragma once

#include <mrpt_mapconv/aerial/Ground.h>

#include "UsedPoints.h"

namespace mrpt_mapconv::aerial
{
/** The map of a cloud's ground.
 * \param used points that count; the others are in no layer
 * \param filterSurface what the filter has found, for cells without a ground point
 * \param frame of the map, around all used points */
GroundLayers mapGround(const cloud::PointCloud& cloud, const UsedPoints& used,
                       const std::vector<std::uint8_t>& classification,
                       const grid::Layer<float>& filterSurface, const grid::GridFrame& frame);

}  // namespace mrpt_mapconv::aerial
