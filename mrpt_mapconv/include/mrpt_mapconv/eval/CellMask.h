#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/sim/World.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mrpt_mapconv::eval
{
/** Which cells are judged: those that are not 0. */
using CellMask = grid::Layer<std::uint8_t>;

/** The cells that both masks have, on the frame of `a`. */
CellMask both(const CellMask& a, const CellMask& b);

/** The cells that `a` has and `b` does not have, on the frame of `a`. */
CellMask without(const CellMask& a, const CellMask& b);

/** The cells of a layer with a value of at least `least`. */
CellMask cellsFrom(const grid::Layer<float>& layer, float least);

/** The free cells of an occupancy layer. */
CellMask freeCells(const grid::Layer<float>& occupancy);

/** The cells of a mask that are farther than `reach` cells, along rows and columns, from every cell
 * that is not in it. What lies beyond the frame is not. \param reach ≥ 0 */
CellMask inside(const CellMask& mask, std::int32_t reach);

/** The cells with a cell of the mask within `reach` cells, along rows and columns, on its frame.
 * \param reach ≥ 0 */
CellMask around(const CellMask& mask, std::int32_t reach);

/** Number of a mask's cells. */
std::size_t count(const CellMask& mask);

/** The cells at whose centre a body stands whose name (without its kind) begins like one of
 * `names`. */
CellMask cellsOf(const sim::World& world, const std::vector<std::string>& names,
                 const grid::GridFrame& frame);

}  // namespace mrpt_mapconv::eval
