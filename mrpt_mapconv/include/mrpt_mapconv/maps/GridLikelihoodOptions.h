#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

namespace mrpt_mapconv::maps
{
/** Reads COccupancyGridMap2D's likelihood options as MRPT does, but strictly: a value that is not a
 * number, or a negative one, is an error, unknown keys give a warning.
 * \exception std::runtime_error naming section, key and value; the options then stay as they were
 */
void loadGridLikelihoodOptions(const mrpt::config::CConfigFileBase& source,
                               const std::string& section,
                               mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions& options);

}  // namespace mrpt_mapconv::maps
