#pragma once

#include <mrpt_mapconv/scan/CellBits.h>

#include <optional>

#include "Slices.h"

namespace mrpt_mapconv::scan
{
/** The height of a ceiling that the structure slice holds, above the robot's base [m]; nothing if
 * it holds none.
 *
 * A ceiling shuts a scan in: the nearest structure points lie in one plane, above which nothing is
 * seen, and objects are cut. Walls fill the slice up to its end, and do not go on behind their
 * nearest point. ScanProfile says exactly how it is recognised.
 *
 * \param objects the cells O, in the square of slices.reach around the sensor's cell */
std::optional<double> ceilingIn(const Slices& slices, const SensorPlace& place,
                                const CellBits& objects, const ProfileParams& params);

}  // namespace mrpt_mapconv::scan
