#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/maps/metric_map_types.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::maps
{
/** \exception std::invalid_argument unless it is within [0.0001, 1000] m: beyond that MRPT's floats
 * fail */
double checkedResolution(double resolution);

/** Reads the flags that all of MRPT's maps share. MRPT has read them already, but takes "true ;
 * why" for false. \exception std::runtime_error naming section, key and value */
void readSharedParams(params::StrictSection& ini, mrpt::maps::TMapGenericParams& shared);

/** Warns of sections that begin with the map's prefix, but end like none of `endings`: most likely
 * a typo. */
void warnUnknownSections(const mrpt::config::CConfigFileBase& source, const std::string& prefix,
                         const std::vector<std::string>& endings);

}  // namespace mrpt_mapconv::maps
