#pragma once

#include <mrpt_mapconv/path/LiftPath.h>

#include <string>

#include "output/Json.h"

namespace mapconv
{
/** A path as a CSV file with the header x,y,z and a point a line [m].
 * \param origin of the path's coordinates, which is added */
std::string pathCsv(const mrpt_mapconv::path::LiftedPath& path, const mrpt::math::TPoint3D& origin);

/** How long a path is in 3D, and in 2D by that name. */
std::string pathLengths(const mrpt_mapconv::path::LiftedPath& path);

/** What became of a path: points, heights, what decided them. @{ */
std::string pathText(const mrpt_mapconv::path::LiftedPath& path);
JsonObject pathJson(const mrpt_mapconv::path::LiftedPath& path);
/** @} */

}  // namespace mapconv
