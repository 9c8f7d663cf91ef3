#include "SensorPlace.h"

#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/observation/FinitePose.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mrpt_mapconv::scan
{
namespace
{
constexpr double kFarthest = 1e9;  // cells from the origin, so that keys stay within 32 bits

void checkHeight(double height, const ProfileParams& params)
{
  // Above all slices is a lidar on a car's roof. fmin passes over what is not set.
  const double low = std::fmin(params.objectMinZ, params.structureMinZ);
  if (height >= low) return;
  std::ostringstream message;
  message << "the sensor is " << height << " m above the robot's base, lower than all that counts ("
          << low << " m): is its pose on the robot right? If so, objectMinZ must not be above it";
  throw UnusableScan(message.str());
}

}  // namespace

SensorPlace placeOf(const Viewpoint& view, double resolution, const ProfileParams& params)
{
  const auto& pose = view.sensorPose;
  if (!observation::isFinite(pose) || !std::isfinite(view.baseZ))
    throw UnusableScan("the scan's pose is not finite");
  if (std::max(std::abs(pose.x()), std::abs(pose.y())) > kFarthest * resolution)
  {
    std::ostringstream message;
    message << "the scan's pose (" << pose.x() << ", " << pose.y() << ") is more than " << kFarthest
            << " cells from the origin";
    throw UnusableScan(message.str());
  }
  checkHeight(pose.z() - view.baseZ, params);
  SensorPlace place;
  place.resolution = resolution;
  place.kx = grid::cellKey(pose.x(), resolution);
  place.ky = grid::cellKey(pose.y(), resolution);
  place.fx = (pose.x() - place.kx * resolution) / resolution;
  place.fy = (pose.y() - place.ky * resolution) / resolution;
  return place;
}

}  // namespace mrpt_mapconv::scan
