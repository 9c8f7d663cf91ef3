#pragma once

#include <mrpt_mapconv/scan/ScanProfile.h>

#include <optional>
#include <vector>

namespace mrpt_mapconv::oracle
{
/** scan::ProfileStatistics::ceiling by its definition in ScanProfile, sector by sector, all points
 * each time. For scans and parameters that are good, with the reflection filter. */
std::optional<double> ceilingOf(const std::vector<mrpt::math::TPoint3Df>& points,
                                const scan::Viewpoint& view, double resolution,
                                const scan::ProfileParams& params);

}  // namespace mrpt_mapconv::oracle
