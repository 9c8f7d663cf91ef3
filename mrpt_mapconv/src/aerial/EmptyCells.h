#pragma once

#include <mrpt_mapconv/grid/Layer.h>

#include <cstdint>
#include <vector>

namespace mrpt_mapconv::aerial
{
/** Gives cells without a height (NaN) that of a membrane spanned over the others: each becomes the
 * mean of its neighbours (four, fewer at the border), to about a millimetre. So a gap in a slope is
 * a slope, and one beside a wall is a ramp.
 *
 * It is spanned over ever coarser grids first, which gives finer ones their start. The result does
 * not depend on the number of threads.
 * \exception std::invalid_argument if no cell has a height */
void fillEmptyCells(grid::Layer<float>& heights, int threads);

/** For each cell the index of the nearest one with a height, its own if it has one; among equally
 * near ones the lowest, among these the first. */
std::vector<std::uint32_t> nearestMeasured(const grid::Layer<float>& heights, int threads);

}  // namespace mrpt_mapconv::aerial
