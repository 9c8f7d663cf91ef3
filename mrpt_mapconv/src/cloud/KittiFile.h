#pragma once

#include <mrpt_mapconv/cloud/CloudFile.h>

#include <string>

#include "BlockInput.h"

namespace mrpt_mapconv::cloud
{
/** Reads a scan of KITTI: x, y, z and intensity of each point as floats.
 * \exception std::runtime_error as readCloud(), also for points that no scanner could have seen */
PointCloud readKitti(BlockInput& input, const CloudReading& reading);

/** Writes the same; points without intensity get 0. \exception std::runtime_error naming the file
 * and the reason, also for coordinates of which floats would lose millimetres */
void writeKitti(const std::string& path, const PointCloud& cloud);

}  // namespace mrpt_mapconv::cloud
