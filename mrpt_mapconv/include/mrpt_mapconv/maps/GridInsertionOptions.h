#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt_mapconv/params/StrictSection.h>

namespace mrpt_mapconv::maps
{
/** Reads COccupancyGridMap2D's insertion options, with its names and units (horizontalTolerance is
 * in degrees), but strictly. Does not warn of other keys: they may be someone else's.
 * \exception std::runtime_error naming section, key and value; the options then stay as they were
 */
void readGridInsertionOptions(params::StrictSection& ini,
                              mrpt::maps::COccupancyGridMap2D::TInsertionOptions& options);

}  // namespace mrpt_mapconv::maps
