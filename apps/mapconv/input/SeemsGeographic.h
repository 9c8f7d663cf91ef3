#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>

namespace mapconv
{
/** Whether a cloud that names no units seems to be one of degrees: a survey that is a few metres
 * high, fits into a hand and is steeper than anything. Rather misses one than takes a mast for one.
 */
bool seemsGeographic(const mrpt_mapconv::cloud::PointCloud& cloud);

}  // namespace mapconv
