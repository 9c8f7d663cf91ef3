#pragma once

#include <optional>

#include "Slices.h"

namespace mrpt_mapconv::scan
{
/** The height of a ceiling that the structure slice holds, above the robot's base [m]; nothing if
 * it holds none.
 *
 * A ceiling shuts a scan in: all around, the nearest structure points lie at nearly one height, and
 * objects lie behind them. Walls are met at all heights of the slice, and behind them lies nothing
 * but reflections. ProfileStatistics::ceiling says exactly how it is recognised.
 *
 * \param sliceHeight of the structure slice [m] */
std::optional<double> ceilingIn(const Slices& slices, const SensorPlace& place, double sliceHeight);

}  // namespace mrpt_mapconv::scan
