#pragma once

#include <mrpt_mapconv/observation/ScanLog.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "output/Progress.h"

namespace mapconv
{
/** Calls `insert` for each scan, in their order, and shows how far it is.
 * \param file what errors name beside the scan's number
 * \exception std::invalid_argument as it is, since it is about the options
 * \exception std::runtime_error for whatever else `insert` throws */
void forEachScan(
    const std::vector<mrpt_mapconv::observation::PosedObservation>& scans, const std::string& file,
    Progress& progress,
    const std::function<void(const mrpt_mapconv::observation::PosedObservation&)>& insert);
/** The same of so many scans, by their index. */
void forEachScan(std::size_t scans, const std::string& file, Progress& progress,
                 const std::function<void(std::size_t)>& insert);

}  // namespace mapconv
