#pragma once

#include <mrpt_mapconv/grid/Layer.h>

#include <cstdint>

namespace mrpt_mapconv::aerial
{
/** The morphological opening of a surface with a disc: the highest surface below it on which a disc
 * could be moved about without touching it from above. Each cell becomes the lowest within
 * `radius`, then the highest of these; cells beyond the border count for neither.
 * \param radius [cells]; the disc has all cells whose centres are at most so far */
grid::Layer<float> openWithDisc(const grid::Layer<float>& surface, std::int32_t radius,
                                int threads);

}  // namespace mrpt_mapconv::aerial
