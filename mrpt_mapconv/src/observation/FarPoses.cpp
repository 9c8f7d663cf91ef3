#include <mrpt_mapconv/observation/FarPoses.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::observation
{
mrpt::math::TPoint3D originOf(const std::vector<PosedObservation>& scans, double resolution)
{
  constexpr double far = 10e3;           // [m], where a float still has millimetres
  constexpr double halfReach = 1 << 14;  // [voxels] of an octree
  const double limit = resolution > 0 ? std::min(far, halfReach * resolution) : far;
  const bool isNear = std::all_of(
      scans.begin(), scans.end(),
      [limit](const PosedObservation& scan)
      { return std::abs(scan.robotPose.x()) <= limit && std::abs(scan.robotPose.y()) <= limit; });
  if (isNear) return {0, 0, 0};
  const auto& first = scans.front().robotPose;
  return {std::round(first.x()), std::round(first.y()), 0};
}

void moveToOrigin(std::vector<PosedObservation>& scans, const mrpt::math::TPoint3D& origin)
{
  for (auto& scan : scans)
  {
    scan.robotPose.x_incr(-origin.x);
    scan.robotPose.y_incr(-origin.y);
    scan.robotPose.z_incr(-origin.z);
  }
}

}  // namespace mrpt_mapconv::observation
