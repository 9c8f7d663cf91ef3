#pragma once

#include <mrpt_mapconv/scan/ScanProfile.h>

#include <string>
#include <vector>

#include "../oracle/ScanOracle.h"
#include "RandomMap.h"

namespace mrpt_mapconv::test
{
/** How the number of lines is chosen. */
enum class Lines
{
  Default,
  Few,    //!< 1 to 8
  Odd,    //!< not divisible by 4
  Fours,  //!< divisible by 4
  Many
};

/** A scan of a made-up place, and how it is to be read. */
struct RandomScan
{
  std::vector<mrpt::math::TPoint3Df> points;
  scan::Viewpoint view;
  double resolution = 1;
  scan::ProfileParams params;

  std::string text() const;
};

/** Any good parameters but for the number of lines, for cells of that size. */
scan::ProfileParams randomParams(Rng& rng, double resolution, scan::Model model, bool filter,
                                 Lines lines);

/** A sensor at any height that the parameters allow, tilted or not, inside of a cell up to 60 cells
 * from the origin. */
scan::Viewpoint randomViewpoint(Rng& rng, double resolution, const scan::ProfileParams& params);

/** Walls, lintels, objects, ghosts, floor and ceiling around a sensor.
 *
 * No point is so near to the border of a cell, of a slice, of the ranges or of an azimuth gap that
 * rounding decides.
 * \param radius how far from the sensor [cells] */
std::vector<mrpt::math::TPoint3Df> randomPoints(Rng& rng, const scan::Viewpoint& view,
                                                double resolution,
                                                const scan::ProfileParams& params, int radius);

/** All of it, within a dozen cells. */
RandomScan randomScan(Rng& rng, scan::Model model, bool filter, Lines lines);

/** The cells of a set, one by one. */
oracle::CellKeys keysOf(const scan::CellBits& cells);

}  // namespace mrpt_mapconv::test
