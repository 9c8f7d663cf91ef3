#include <mrpt_mapconv/voxel/CloudRays.h>

#include <stdexcept>
#include <vector>

namespace mrpt_mapconv::voxel
{
InsertedCloud insertCloud(VoxelGrid& grid, const cloud::PointCloud& cloud,
                          const observation::PoseTrack& sensor,
                          const observation::CloudTimes& times, const RayParams& params,
                          int threads)
{
  if (cloud.time.size() != cloud.size())
    throw std::invalid_argument(
        "the cloud has no times, so nobody knows from where a point was seen");
  constexpr std::size_t kPiece = 1'000'000;  // rays, which are copied
  InsertedCloud inserted;
  std::vector<Ray> rays;
  const auto flush = [&]
  {
    inserted.points += insertRays(grid, rays, params, threads).rays;
    rays.clear();
  };
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    if (!cloud.withheld.empty() && cloud.withheld[i])
    {
      ++inserted.withheld;
      continue;
    }
    const auto pose = sensor.at(times.stampOf(cloud.time[i]), times.maxGap);
    if (!pose)
    {
      ++inserted.uncovered;
      continue;
    }
    rays.push_back({pose->translation() - cloud.origin, {cloud.x[i], cloud.y[i], cloud.z[i]}});
    if (rays.size() == kPiece) flush();
  }
  flush();
  return inserted;
}

}  // namespace mrpt_mapconv::voxel
