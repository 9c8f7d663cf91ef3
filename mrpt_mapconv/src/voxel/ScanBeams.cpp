#include "ScanBeams.h"

#include <mrpt_mapconv/observation/FinitePose.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace mrpt_mapconv::voxel
{
namespace
{
octomap::point3d toOctomap(double x, double y, double z)
{
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

/** From a sensor's frame to the map's, as mrpt::poses::CPose3D::composePoint(): of that a call for
 * each point takes longer than the sums. */
class ToMap
{
 public:
  explicit ToMap(const mrpt::poses::CPose3D& pose)
      : m_rotation(pose.getRotationMatrix()), m_x(pose.x()), m_y(pose.y()), m_z(pose.z())
  {
  }
  octomap::point3d operator()(const mrpt::math::TPoint3Df& point) const
  {
    const auto row = [&](int i)
    {
      return m_rotation(i, 0) * static_cast<double>(point.x) +
             m_rotation(i, 1) * static_cast<double>(point.y) +
             m_rotation(i, 2) * static_cast<double>(point.z);
    };
    return toOctomap(row(0) + m_x, row(1) + m_y, row(2) + m_z);
  }

 private:
  mrpt::math::CMatrixDouble33 m_rotation;
  double m_x, m_y, m_z;
};
}  // namespace

ScanBeams::ScanBeams(const OctomapKeys& mapKeys, const observation::SensorPoints& scan,
                     double maxRange)
    : keys(mapKeys),
      origin(toOctomap(scan.sensorPose.x(), scan.sensorPose.y(), scan.sensorPose.z()))
{
  const auto sensor = keys.keyOf(origin);
  if (!observation::isFinite(scan.sensorPose) || !sensor)
    throw std::runtime_error("sensor pose " + scan.sensorPose.asString() +
                             " is not finite or outside the voxel map's range");
  originKey = *sensor;
  const auto isWhole = [&](const octomap::point3d& end)
  { return maxRange < 0 || (end - origin).norm() <= maxRange; };
  const auto add = [this](octomap::point3d end, std::vector<Beam>& beams)
  {
    // along a beam whose length is 0 in floats OctoMap walks for ever
    if ((end - origin).norm_sq() == 0) end = origin;
    if (const auto key = keys.keyOf(end))
      beams.push_back({end, *key});
    else
      ++outside;
  };
  const ToMap toMap(scan.sensorPose);
  hits.reserve(scan.points.size());
  misses.reserve(scan.noReturns.size());
  for (const auto* points : {&scan.points, &scan.noReturns})
    for (const auto& point : *points)
    {
      const auto end = toMap(point);
      if (isWhole(end))
        add(end, points == &scan.points ? hits : misses);
      else
        add(origin + (end - origin).normalized() * static_cast<float>(maxRange), misses);
    }
}

grid::GridFrame ScanBeams::frame() const
{
  std::int32_t xMin = originKey.x, xMax = xMin, yMin = originKey.y, yMax = yMin;
  for (const auto* beams : {&hits, &misses})
    for (const auto& beam : *beams)
    {
      xMin = std::min(xMin, beam.key.x);
      xMax = std::max(xMax, beam.key.x);
      yMin = std::min(yMin, beam.key.y);
      yMax = std::max(yMax, beam.key.y);
    }
  return {keys.resolution(), xMin, yMin, xMax - xMin + 1, yMax - yMin + 1};
}

}  // namespace mrpt_mapconv::voxel
