#pragma once

#include <mrpt_mapconv/scan/ProfileParams.h>

#include <string>

namespace mrpt_mapconv::scan
{
/** The gist of how scans are seen, for people, e.g. "wholeShape, objects from 0.05 to 1.5 m, walls
 * from 2.3 to 2.6 m". */
std::string summaryOf(const ProfileParams& params);

}  // namespace mrpt_mapconv::scan
