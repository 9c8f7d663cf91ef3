#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>

#include <vector>

namespace mrpt_mapconv::observation
{
/** What a range sensor saw at one moment. */
struct SensorPoints
{
  mrpt::poses::CPose3D sensorPose;            //!< sensor frame -> map: robot ⊕ sensor on robot
  std::vector<mrpt::math::TPoint3Df> points;  //!< in the sensor frame [m]; finite, not (0,0,0)
  double azimuthStep = 0;  //!< between neighbouring columns of the sensor [rad]; 0: not known
  /** Ends, as those of points, of beams that met nothing up to the sensor's maximum range: nothing
   * lies there, but all before it is free. */
  std::vector<mrpt::math::TPoint3Df> noReturns = {};
  mrpt::poses::CPose3D robotPose = {};  //!< robot frame -> map

  bool empty() const { return points.empty() && noReturns.empty(); }
  /** Forgets all but the pose; the memory is kept. */
  void clear()
  {
    points.clear();
    noReturns.clear();
    azimuthStep = 0;
  }
};

}  // namespace mrpt_mapconv::observation
