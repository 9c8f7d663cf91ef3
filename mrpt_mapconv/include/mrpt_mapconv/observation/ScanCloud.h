#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/observation/SayOnceLog.h>
#include <mrpt_mapconv/observation/ScanLog.h>

namespace mrpt_mapconv::observation
{
/** Adds the points of a scan, in the map frame, to a cloud without attributes.
 * \param warnings told of what could not be used; may be null
 * \exception std::runtime_error as sensorPoints() */
void appendScan(const PosedObservation& scan, cloud::PointCloud& cloud,
                SayOnceLog* warnings = nullptr);

}  // namespace mrpt_mapconv::observation
