#pragma once

#include <mrpt_mapconv/cloud/CloudFile.h>

#include <string>

#include "BlockInput.h"

namespace mrpt_mapconv::cloud
{
/** Reads a `.pcd` of PCL: ascii, binary or binary_compressed. The VIEWPOINT is not applied.
 * \exception std::runtime_error as readCloud() */
PointCloud readPcd(BlockInput& input, const CloudReading& reading);

/** Writes a binary `.pcd` with coordinates and times of 8 bytes.
 * \exception std::runtime_error naming the file and the reason */
void writePcd(const std::string& path, const PointCloud& cloud);

}  // namespace mrpt_mapconv::cloud
