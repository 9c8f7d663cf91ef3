#pragma once

#include <mrpt_mapconv/cloud/CloudFile.h>

#include <string>

#include "BlockInput.h"

namespace mrpt_mapconv::cloud
{
/** Reads the vertices of a `.ply`: ascii, or binary in either byte order.
 * \exception std::runtime_error as readCloud() */
PointCloud readPly(BlockInput& input, const CloudReading& reading);

/** Writes a `.ply`, little endian, with coordinates and times of 8 bytes.
 * \exception std::runtime_error naming the file and the reason */
void writePly(const std::string& path, const PointCloud& cloud);

}  // namespace mrpt_mapconv::cloud
