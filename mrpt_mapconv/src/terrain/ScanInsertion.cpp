#include <mrpt_mapconv/terrain/ScanInsertion.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace mrpt_mapconv::terrain
{
UsedPoints usedPoints(const observation::SensorPoints& scan, const PointLimits& limits)
{
  constexpr double kFar = std::numeric_limits<double>::infinity();
  UsedPoints used;
  used.points.reserve(scan.points.size());
  used.xMin = used.yMin = kFar;
  used.xMax = used.yMax = -kFar;
  const auto& pose = scan.sensorPose;
  const auto turn = pose.getRotationMatrix();
  const auto row = [&turn](int i, const mrpt::math::TPoint3Df& p)
  {
    return turn(i, 0) * static_cast<double>(p.x) + turn(i, 1) * static_cast<double>(p.y) +
           turn(i, 2) * static_cast<double>(p.z);
  };
  const double above = pose.z() - scan.robotPose.z(), mostRange = limits.maxRange * limits.maxRange;
  for (const auto& point : scan.points)
  {
    const double height = row(2, point) + above;
    if (static_cast<double>(point.sqrNorm()) > mostRange || height < limits.minHeight ||
        height > limits.maxHeight)
      continue;
    used.points.push_back(point);
    const double x = row(0, point) + pose.x(), y = row(1, point) + pose.y();
    used.xMin = std::min(used.xMin, x);
    used.xMax = std::max(used.xMax, x);
    used.yMin = std::min(used.yMin, y);
    used.yMax = std::max(used.yMax, y);
  }
  used.leftOut = scan.points.size() - used.points.size();
  return used;
}

grid::GridFrame frameOf(const UsedPoints& points, const TerrainMap& map)
{
  grid::GridFrame frame{map.resolution(), 0, 0, 0, 0, -0.5};
  if (points.points.empty()) return frame;
  constexpr double kMostKey = 1 << 30;
  for (const double metres : {points.xMin, points.xMax, points.yMin, points.yMax})
    if (!(std::abs(metres) < kMostKey * map.resolution()))
      throw std::runtime_error("a point at " + std::to_string(metres) +
                               " m is too far from the origin for cells of " +
                               std::to_string(map.resolution()) + " m");
  frame.x0 = map.keyOf(points.xMin);
  frame.y0 = map.keyOf(points.yMin);
  frame.width = map.keyOf(points.xMax) - frame.x0 + 1;
  frame.height = map.keyOf(points.yMax) - frame.y0 + 1;
  return frame;
}

TerrainScan terrainScan(const observation::SensorPoints& scan, const UsedPoints& points,
                        const mrpt::math::CMatrixDouble33& poseCovariance)
{
  static_assert(sizeof(mrpt::math::TPoint3Df) == 3 * sizeof(float));
  TerrainScan out;
  out.points = points.points.size();
  out.stride = 3;
  if (out.points > 0)
  {
    const mrpt::math::TPoint3Df& first = points.points.front();
    out.x = &first.x;
    out.y = &first.y;
    out.z = &first.z;
  }
  out.sensorPose = scan.sensorPose;
  out.robotPose = scan.robotPose;
  out.poseCovariance = poseCovariance;
  return out;
}

InsertedPoints insertScan(TerrainMap& map, const observation::SensorPoints& scan,
                          const UsedPoints& points, const PointSigmas& sigmas,
                          const mrpt::math::CMatrixDouble33& poseCovariance)
{
  return map.insert(terrainScan(scan, points, poseCovariance), sigmas);
}

}  // namespace mrpt_mapconv::terrain
