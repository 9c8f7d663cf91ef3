#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/eval/CellMask.h>

#include <vector>

namespace mapconv
{
/** Where a robot is to go. */
struct Pair
{
  mrpt::math::TPoint2D start, goal;  //!< [m]
};

/** Random start–goal pairs in cells in view, at least 5 m apart, between which there is a way in
 * the true map; the same ones in each run. Fewer than `count` if such pairs are rare.
 * \param robotRadius that the way is wide enough for [m] */
std::vector<Pair> randomPairs(const mrpt_mapconv::grid::Layer<float>& truth,
                              const mrpt_mapconv::eval::CellMask& inView, double robotRadius,
                              int count);

}  // namespace mapconv
