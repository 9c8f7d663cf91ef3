#pragma once

#include <mrpt_mapconv/path/LiftPath.h>

#include <string>

#include "output/Json.h"

namespace mapconv
{
/** A path as a CSV file with the header x,y,z and a point a line [m], its shownOrigin added. */
std::string pathCsv(const mrpt_mapconv::path::LiftedPath& path);

/** How long a path is in 3D, and in 2D by that name. */
std::string pathLengths(const mrpt_mapconv::path::LiftedPath& path);

/** What became of a path: points, heights with its shownOrigin, what decided them. @{ */
std::string pathText(const mrpt_mapconv::path::LiftedPath& path);
JsonObject pathJson(const mrpt_mapconv::path::LiftedPath& path);
/** @} */

}  // namespace mapconv
