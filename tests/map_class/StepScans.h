#pragma once

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

namespace step_grid::testing
{
/** A floor of 2 x 2 m at z = 0 around (xMiddle, 0), with a kerb 0.5 m high along x = xMiddle + 0.55
 * and one of 0.1 m along x = xMiddle − 0.55, as points in the sensor's frame 1 m above the floor.
 */
inline mrpt::obs::CObservationPointCloud kerbScan(float xMiddle = 0)
{
  auto cloud = mrpt::maps::CSimplePointsMap::Create();
  for (int ix = -10; ix < 10; ++ix)
    for (int iy = -10; iy < 10; ++iy)
    {
      const float x = xMiddle + 0.1f * static_cast<float>(ix) + 0.05f;
      const float y = 0.1f * static_cast<float>(iy) + 0.05f;
      cloud->insertPoint(x, y, -1);
      if (ix == 5) cloud->insertPoint(x, y, -0.5f);
      if (ix == -6) cloud->insertPoint(x, y, -0.9f);
    }
  mrpt::obs::CObservationPointCloud scan;
  scan.pointcloud = cloud;
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 1);
  scan.sensorLabel = "LIDAR";
  return scan;
}

}  // namespace step_grid::testing
