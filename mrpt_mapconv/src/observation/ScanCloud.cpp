#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanCloud.h>

namespace mrpt_mapconv::observation
{
void appendScan(const PosedObservation& scan, cloud::PointCloud& cloud, SayOnceLog* warnings)
{
  const auto seen = sensorPoints(*scan.observation, scan.robotPose, warnings);
  if (!seen) return;
  for (const auto& point : seen->points)
  {
    const auto placed = seen->sensorPose.composePoint(mrpt::math::TPoint3D(point));
    cloud.x.push_back(placed.x);
    cloud.y.push_back(placed.y);
    cloud.z.push_back(placed.z);
  }
}

}  // namespace mrpt_mapconv::observation
