#pragma once

#include <mrpt_mapconv/cloud/CloudFile.h>

#include <string>

#include "BlockInput.h"

namespace mrpt_mapconv::cloud
{
/** Reads `.las` 1.0 to 1.4, point formats 0 to 10. \exception std::runtime_error as readCloud() */
PointCloud readLas(BlockInput& input, const CloudReading& reading);

/** Writes LAS 1.4 with whole millimetres: point format 0, or 6 if the cloud has times, classes
 * above 31 or more than seven returns. Intensities that are no whole numbers of 0 to 65535 are left
 * out; one that is NaN is 0. \exception std::runtime_error naming the file and the reason */
void writeLas(const std::string& path, const PointCloud& cloud);

}  // namespace mrpt_mapconv::cloud
