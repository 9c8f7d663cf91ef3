#pragma once

#include <mrpt_mapconv/grid/Layer.h>

namespace mrpt_mapconv::aerial
{
/** How a surface rises on the whole. Filters that know up and down only, not across a slope, work
 * on what is left of a surface without it: then a hillside is as easy as a plain. */
struct MeanSlope
{
  double x = 0, y = 0;  //!< [m/cell]

  /** Of the least-squares plane through a surface without gaps. */
  static MeanSlope of(const grid::Layer<float>& surface);

  MeanSlope operator-() const { return {-x, -y}; }
};

/** Adds a plane of that slope which is 0 in the middle. */
void tilt(grid::Layer<float>& heights, const MeanSlope& slope);

}  // namespace mrpt_mapconv::aerial
