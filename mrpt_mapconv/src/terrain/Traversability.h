#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

namespace mrpt_mapconv::terrain
{
/** Noise spreads a step over so much [m]. */
constexpr double kEdge = 0.1;

/** Where a robot can walk: 0 free, 1 occupied, −1 where the height is not known. Occupied is
 * - a cell whose plane is steeper than maxSlope;
 * - a cell with one of its 8 neighbours more than maxStep higher or lower;
 * - a cell without a plane where heights within 0.1 m around it differ by more than maxStep: at an
 *   edge noise mixes what is above with what is below, so that the step is spread over some cells;
 * - a cell on the edge of a drop of more than maxStep whose foot nobody saw, see dropEdges().
 */
grid::Layer<float> traversabilityOf(const TerrainLayers& layers, const TerrainParams& params);

}  // namespace mrpt_mapconv::terrain
