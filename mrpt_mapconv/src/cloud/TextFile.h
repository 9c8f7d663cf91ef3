#pragma once

#include <mrpt_mapconv/cloud/CloudFile.h>

#include <string>

#include "BlockInput.h"

namespace mrpt_mapconv::cloud
{
/** Reads a text of one point a line, its numbers separated by blanks, tabs, commas or semicolons.
 * Before the first point there may be a line of names, a line with the number of points, and
 * comments (# or //), the last of which may be the names.
 * \exception std::runtime_error as readCloud() */
PointCloud readText(BlockInput& input, const CloudReading& reading);

/** Writes a line of names, and one for each point: with commas to `.csv`, else with blanks.
 * \exception std::runtime_error naming the file and the reason */
void writeText(const std::string& path, const PointCloud& cloud);

}  // namespace mrpt_mapconv::cloud
