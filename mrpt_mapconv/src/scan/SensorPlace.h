#pragma once

#include <mrpt_mapconv/scan/ScanProfile.h>

#include <cstdint>

namespace mrpt_mapconv::scan
{
/** The distance along one axis from the sensor to the centre of the cell i cells on [cells]. The
 * same number as a walk that counts cells against the axis gets.
 * \param fraction where in its cell the sensor is, in [0, 1] */
inline double axisDistance(std::int32_t i, double fraction)
{
  return i < 0 ? -i + 0.5 - (1 - fraction) : i + 0.5 - fraction;
}

/** Where the sensor is among the cells. Cells are counted from the one that it is in. */
struct SensorPlace
{
  std::int32_t kx = 0, ky = 0;  //!< key of the cell
  double fx = 0, fy = 0;        //!< where in it [cells], in [0, 1)
  double resolution = 0;        //!< [m]

  /** Square of the distance from the sensor to the centre of a cell [cells²]. */
  double distanceSq(std::int32_t ix, std::int32_t iy) const
  {
    const double dx = axisDistance(ix, fx), dy = axisDistance(iy, fy);
    return dx * dx + dy * dy;
  }
};

/** \exception UnusableScan if the sensor's pose is not finite, too far away or too low */
SensorPlace placeOf(const Viewpoint& view, double resolution, const ProfileParams& params);

}  // namespace mrpt_mapconv::scan
