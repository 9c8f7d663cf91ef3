#pragma once

#include <mrpt/poses/CPose3D.h>

#include <cmath>

namespace mrpt_mapconv::observation
{
/** True if no coordinate and no angle is NaN or infinite. */
inline bool isFinite(const mrpt::poses::CPose3D& pose)
{
  // A sum is finite only if every term is.
  return std::isfinite(pose.x() + pose.y() + pose.z() + pose.yaw() + pose.pitch() + pose.roll());
}

}  // namespace mrpt_mapconv::observation
