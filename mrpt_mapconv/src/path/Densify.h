#pragma once

#include <mrpt_mapconv/path/LiftPath.h>

#include <vector>

namespace mrpt_mapconv::path
{
/** A path with points added, and how far along it they lie. */
struct DensePath
{
  std::vector<LiftedPoint> points;  //!< z = 0
  std::vector<double> arc;          //!< 2D length of the path up to each point [m]
};

/** Keeps a path's points and adds others, evenly, until no spacing exceeds `spacing` [m].
 * \exception std::invalid_argument if that would be more than 10 million points */
DensePath densify(const std::vector<mrpt::math::TPoint2D>& path, double spacing);

}  // namespace mrpt_mapconv::path
