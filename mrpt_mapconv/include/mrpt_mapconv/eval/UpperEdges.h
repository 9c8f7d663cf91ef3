#pragma once

#include <mrpt_mapconv/eval/CellMask.h>

namespace mrpt_mapconv::eval
{
/** The cells beside drops: those whose floor is more than `drop` above that of one of the 8 cells
 * around, both known. The upper faces of what stands about have such edges, too; see cellsOf() and
 * without().
 *
 * \param floor heights [m], NaN where unknown, as truthLayers() gives them
 * \param drop [m]; a difference within 1e-5 m of it is none, since floors have single precision
 * \exception std::invalid_argument unless it is finite and at least 0 m */
CellMask upperEdges(const grid::Layer<float>& floor, double drop);

/** The cells below drops: those whose floor is more than `drop` below that of one of the 8 cells
 * around. Parameters and exceptions as for upperEdges(). */
CellMask lowerEdges(const grid::Layer<float>& floor, double drop);

}  // namespace mrpt_mapconv::eval
