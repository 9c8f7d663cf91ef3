#include "RaySnapping.h"

#include <mrpt/core/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace mrpt_mapconv::voxel
{
namespace
{
class Snapper
{
 public:
  Snapper(double resolution, double maxRange)
      : m_scale(static_cast<double>(kRayUnits) / resolution), m_maxRange(maxRange)
  {
  }

  /** \return false for a ray that is not finite
   * \exception std::out_of_range beyond the keys' range */
  bool snap(const Ray& ray, GridRay& snapped, RayEnd& atEnd) const
  {
    if (!isFinite(ray.origin) || !isFinite(ray.end)) return false;
    auto end = ray.end;
    if (m_maxRange > 0)
    {
      const auto beam = ray.end - ray.origin;
      const double length = lengthOf(beam);
      if (length > m_maxRange)
      {
        end = ray.origin + beam * (m_maxRange / length);
        atEnd = RayEnd::Clear;
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      snapped.from[i] = unitsOf(ray.origin[i]);
      snapped.to[i] = unitsOf(end[i]);
    }
    return true;
  }

 private:
  static bool isFinite(const mrpt::math::TPoint3D& p)
  {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }
  static double lengthOf(const mrpt::math::TPoint3D& beam)
  {
    const double length = beam.norm();
    return std::isfinite(length) ? length : std::hypot(beam.x, beam.y, beam.z);
  }
  std::int64_t unitsOf(double metres) const
  {
    constexpr double most = 2147483648.0 * static_cast<double>(kRayUnits);
    const double units = std::floor(metres * m_scale + 0.5);
    if (units >= -most && units < most) return static_cast<std::int64_t>(units);
    throw std::out_of_range(
        mrpt::format("%g m is %g voxels from the map's origin; 2^31 is the limit", metres,
                     metres * m_scale / static_cast<double>(kRayUnits)));
  }

  double m_scale, m_maxRange;
};
}  // namespace

SnappedRays snapRays(const std::vector<Ray>& rays, double resolution, double maxRange)
{
  const Snapper snapper(resolution, maxRange);
  SnappedRays snapped;
  snapped.rays.reserve(rays.size());
  snapped.ends.reserve(rays.size());
  for (std::size_t r = 0; r < rays.size(); ++r)
  {
    auto [ray, atEnd] = std::pair{GridRay{}, rays[r].atEnd};
    try
    {
      if (!snapper.snap(rays[r], ray, atEnd))
      {
        ++snapped.counts.notFinite;
        continue;
      }
    }
    catch (const std::out_of_range& error)
    {
      throw std::out_of_range("ray " + std::to_string(r + 1) + " of " +
                              std::to_string(rays.size()) + ": " + error.what());
    }
    snapped.rays.push_back(ray);
    snapped.ends.push_back(atEnd);
    snapped.counts.updates += atEnd == RayEnd::Keep ? 0 : 1;
    for (std::size_t i = 0; i < 3; ++i)
      snapped.counts.updates +=
          static_cast<std::size_t>(std::abs((ray.to[i] >> kRayBits) - (ray.from[i] >> kRayBits)));
  }
  snapped.counts.rays = snapped.rays.size();
  return snapped;
}

}  // namespace mrpt_mapconv::voxel
