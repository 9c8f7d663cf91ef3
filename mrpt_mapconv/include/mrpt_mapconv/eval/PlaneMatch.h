#pragma once

#include <mrpt_mapconv/eval/OccupancyScore.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <cstddef>
#include <cstdint>

namespace mrpt_mapconv::eval
{
/** How a map's planes and true ones are matched. */
struct PlaneMatchParams
{
  double overlap = 0.8;       //!< least share of the cells of either that the other has, above 0.5
  std::size_t minCells = 12;  //!< what has fewer judged cells is not counted
};

/** Compares regions (Hoover et al. 1996): a plane of the map and a true one are a correct detection
 * if each has at least that share of the other's judged cells. Counts planes, not cells.
 *
 * Judged are cells that have a true plane and that the map knows. A plane of the map that has too
 * few of them, as it lies where no plane is true, is neither right nor wrong.
 *
 * \param map indices of its planes; NaN: none
 * \param height of the map; NaN: not known
 * \param truth indices of true planes; negative: none
 * \exception std::invalid_argument for different resolutions, or overlap not in (0.5, 1] */
Agreement matchPlanes(const grid::Layer<float>& map, const grid::Layer<float>& height,
                      const grid::Layer<std::int32_t>& truth, const PlaneMatchParams& params);

}  // namespace mrpt_mapconv::eval
