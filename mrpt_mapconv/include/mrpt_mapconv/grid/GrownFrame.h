#pragma once

#include <mrpt_mapconv/grid/GridFrame.h>

#include <functional>
#include <limits>

namespace mrpt_mapconv::grid
{
/** How much further than asked for a grid grows on a side, so that laying it out anew stays rare.
 */
struct GrowthMargin
{
  double share;                                           //!< of the grid's whole side
  double most = std::numeric_limits<double>::infinity();  //!< [m]
  std::int32_t least = 0;                                 //!< [cells]
};

/** A frame that holds both, and a margin on those sides where `frame` has to grow; without any
 * margin if that is not allowed.
 *
 * \param frame where the grid lies; if it is empty there are margins on all sides
 * \param isAllowed asked only of the frame with its margins */
GridFrame grownFrame(const GridFrame& frame, const GridFrame& needed, const GrowthMargin& margin,
                     const std::function<bool(const GridFrame&)>& isAllowed);

}  // namespace mrpt_mapconv::grid
