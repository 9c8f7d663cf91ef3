#include "Slices.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace mrpt_mapconv::scan
{
using mrpt::math::TPoint3Df;

namespace
{
/** A number rounded down, as fast as a cast; |value| < 2^31. */
std::int32_t floorOf(double value)
{
  const auto cut = static_cast<std::int32_t>(value);
  return cut - (value < cut ? 1 : 0);
}

struct HeightRange
{
  double low, high;
  bool holds(double z) const { return z >= low && z <= high; }
};

/** One row of the rotation from the sensor's frame to the map's. */
struct RotationRow
{
  double x, y, z;
  double operator()(const TPoint3Df& p) const { return x * p.x + y * p.y + z * p.z; }
};

RotationRow rowOf(const Viewpoint& view, int i)
{
  const auto& rotation = view.sensorPose.getRotationMatrix();
  return {rotation(i, 0), rotation(i, 1), rotation(i, 2)};
}
}  // namespace

void Slices::take(const std::vector<TPoint3Df>& points, const Viewpoint& view,
                  const SensorPlace& place, const ProfileParams& params)
{
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  constexpr double kFarthest = 1e9;  // cells; so that they can be counted
  const double sensorZ = view.sensorPose.z() - view.baseZ;
  const HeightRange objects{params.objectMinZ - sensorZ, params.objectMaxZ - sensorZ};
  const HeightRange structures =
      params.reflectionFilter
          ? HeightRange{params.structureMinZ - sensorZ, params.structureMaxZ - sensorZ}
          : HeightRange{kNowhere, -kNowhere};
  const RotationRow toX = rowOf(view, 0), toY = rowOf(view, 1), toZ = rowOf(view, 2);
  const double minSq = params.minRange * params.minRange, maxSq = params.maxRange * params.maxRange;
  const double perMetre = 1 / place.resolution;
  const double farthestSq = kFarthest * place.resolution * kFarthest * place.resolution;

  object.clear();
  object.reserve(points.size());
  structure.clear();
  std::int32_t low = 0, high = 0;
  for (const TPoint3Df& point : points)
  {
    const double z = toZ(point);
    const bool isObject = objects.holds(z), isStructure = structures.holds(z);
    if (!isObject && !isStructure) continue;
    const double x = toX(point), y = toY(point);
    const double rangeSq = x * x + y * y;
    if (!(rangeSq <= (isStructure ? farthestSq : maxSq))) continue;  // NaN, too
    const CellOffset cell{floorOf(place.fx + x * perMetre), floorOf(place.fy + y * perMetre)};
    // what is where the sensor is is no return
    if (isStructure && (rangeSq > 0 || z != 0)) structure.push_back({cell, x, y, sensorZ + z});
    if (!isObject || rangeSq < minSq || rangeSq > maxSq) continue;
    object.push_back(cell);
    low = std::min({low, cell.x, cell.y});
    high = std::max({high, cell.x, cell.y});
  }
  reach = std::max(-low, high);
}

}  // namespace mrpt_mapconv::scan
