#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt_mapconv/params/Fields.h>

namespace mrpt_mapconv
{
/** The list of COccupancyGridMap2D's insertion options, with its names and units. */
template <>
struct params::FieldsOf<mrpt::maps::COccupancyGridMap2D::TInsertionOptions>
{
  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    v("mapAltitude", o.mapAltitude, "m", "height of the plane that 2D scans have to lie in");
    v("useMapAltitude", o.useMapAltitude, "", "whether they have to");
    v("maxDistanceInsertion", o.maxDistanceInsertion, "m", "longest part of a 2D ray");
    v("maxOccupancyUpdateCertainty", o.maxOccupancyUpdateCertainty, "",
      "what a hit of a 2D ray is worth, 0.5 to 1");
    v("maxFreenessUpdateCertainty", o.maxFreenessUpdateCertainty, "",
      "what a cell before it is worth, 0.5 to 1; 0 = maxOccupancyUpdateCertainty");
    v("maxFreenessInvalidRanges", o.maxFreenessInvalidRanges, "",
      "what a cell along an invalid 2D ray is worth; 0 = maxOccupancyUpdateCertainty");
    v("considerInvalidRangesAsFreeSpace", o.considerInvalidRangesAsFreeSpace, "",
      "whether invalid 2D rays say anything");
    v("decimation", o.decimation, "", "of so many 2D rays one is used");
    v("horizontalTolerance", params::Degrees(o.horizontalTolerance), "degrees",
      "how far a 2D scan may be from level");
    v("CFD_features_gaussian_size", o.CFD_features_gaussian_size, "cells",
      "for MRPT's landmarks of grids");
    v("CFD_features_median_size", o.CFD_features_median_size, "cells",
      "for MRPT's landmarks of grids");
    v("wideningBeamsWithDistance", o.wideningBeamsWithDistance, "",
      "whether 2D rays widen with their distance");
  }
};
}  // namespace mrpt_mapconv

namespace mrpt_mapconv::maps
{
/** Reads COccupancyGridMap2D's insertion options, with its names and units (horizontalTolerance is
 * in degrees), but strictly. Does not warn of other keys: they may be someone else's.
 * \exception std::runtime_error naming section, key and value; the options then stay as they were
 */
void readGridInsertionOptions(params::StrictSection& ini,
                              mrpt::maps::COccupancyGridMap2D::TInsertionOptions& options);

}  // namespace mrpt_mapconv::maps
