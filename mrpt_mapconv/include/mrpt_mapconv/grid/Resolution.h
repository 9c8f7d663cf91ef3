#pragma once

#include <mrpt_mapconv/params/Require.h>

namespace mrpt_mapconv::grid
{
/** What the resolution of a map class must be. */
constexpr const char* kRightResolution = "within [0.0001, 1000] m";

/** True for a resolution [m] that MRPT's grids, which count in floats, can work with. */
inline bool isResolution(double resolution) { return resolution >= 1e-4 && resolution <= 1e3; }

/** \exception std::invalid_argument unless isResolution() */
inline void requireResolution(double resolution)
{
  params::require(isResolution(resolution), "resolution", resolution, kRightResolution);
}

}  // namespace mrpt_mapconv::grid
