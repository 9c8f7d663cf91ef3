#include "RandomRays.h"

#include <algorithm>

namespace mrpt_mapconv::test
{
using voxel::GridRay;
using voxel::kRayUnits;

GridRay RandomRays::alongAxis()
{
  GridRay ray = between(0, 1) ? anywhere() : betweenCorners();
  const auto axis = static_cast<std::size_t>(between(0, 2));
  for (std::size_t i = 0; i < 3; ++i)
    if (i != axis) ray.to[i] = ray.from[i];
  return ray;
}

GridRay RandomRays::betweenCorners() { return {corner(), corner()}; }

GridRay RandomRays::diagonal()
{
  GridRay ray{corner(), {}};
  std::array<std::int64_t, 3> direction{};
  std::int64_t most = m_high - m_low;
  for (std::size_t i = 0; i < 3; ++i)
  {
    direction[i] = between(0, 1) ? 1 : -1;
    most = std::min(most, direction[i] > 0 ? m_high - 1 - ray.from[i] : ray.from[i] - m_low);
  }
  const std::int64_t skipped = between(0, 1) ? 0 : between(0, most);
  const std::int64_t length = between(0, 1) ? most : most / kRayUnits * kRayUnits;
  for (std::size_t i = 0; i < 3; ++i)
  {
    ray.to[i] = ray.from[i] + direction[i] * std::max(length, skipped);
    ray.from[i] += direction[i] * skipped;
  }
  return ray;
}

GridRay RandomRays::inPlane()
{
  GridRay ray = between(0, 1) ? anywhere() : betweenCorners();
  const auto axis = static_cast<std::size_t>(between(0, 2));
  ray.from[axis] = ray.to[axis] = face() + (between(0, 1) ? 0 : kRayUnits / 2);
  return ray;
}

GridRay RandomRays::withoutLength()
{
  const auto at = between(0, 1) ? point() : corner();
  return {at, at};
}

GridRay RandomRays::tiny()
{
  GridRay ray = between(0, 1) ? anywhere() : betweenCorners();
  const std::int64_t reach = between(0, 1) ? 2 : 2 * kRayUnits;
  for (std::size_t i = 0; i < 3; ++i)
    ray.to[i] = std::clamp(ray.from[i] + between(-reach, reach), m_low, m_high - 1);
  return ray;
}

GridRay RandomRays::any()
{
  switch (between(0, 6))
  {
    case 0:
      return alongAxis();
    case 1:
      return betweenCorners();
    case 2:
      return diagonal();
    case 3:
      return inPlane();
    case 4:
      return withoutLength();
    case 5:
      return tiny();
    default:
      return anywhere();
  }
}

voxel::Ray inMetres(const GridRay& ray, double resolution, voxel::RayEnd atEnd)
{
  const auto metres = [resolution](const std::array<std::int64_t, 3>& units)
  {
    const auto of = [resolution](std::int64_t u)
    { return static_cast<double>(u) / static_cast<double>(kRayUnits) * resolution; };
    return mrpt::math::TPoint3D(of(units[0]), of(units[1]), of(units[2]));
  };
  return {metres(ray.from), metres(ray.to), atEnd};
}

}  // namespace mrpt_mapconv::test
