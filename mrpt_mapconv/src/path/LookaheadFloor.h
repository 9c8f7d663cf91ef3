#pragma once

#include <vector>

namespace mrpt_mapconv::path
{
/** For each point of a path the highest floor within `reach` of arc length before and behind, ends
 * included.
 *
 * \param arc length of the path up to each point, not decreasing [m]
 * \param floors below the points [m]; NaN where there is none
 * \return NaN where no point in reach has a floor */
std::vector<float> highestFloors(const std::vector<double>& arc, const std::vector<float>& floors,
                                 double reach);

}  // namespace mrpt_mapconv::path
