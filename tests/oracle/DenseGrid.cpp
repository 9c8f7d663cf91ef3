#include "DenseGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv::oracle
{
using voxel::GridRay;
using voxel::VoxelKey;

namespace
{
using Point = std::array<long double, 3>;

std::optional<Point> pointOf(const mrpt::math::TPoint3D& p)
{
  if (!std::isfinite(p.x + p.y + p.z)) return std::nullopt;
  return Point{p.x, p.y, p.z};
}

GridRay unitsOf(const Point& from, const Point& to, double resolution)
{
  constexpr long double kUnits = 256;  // of a voxel
  GridRay ray;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto nearest = [resolution](long double metres)
    { return static_cast<std::int64_t>(std::floor(metres / resolution * kUnits + 0.5L)); };
    ray.from[i] = nearest(from[i]);
    ray.to[i] = nearest(to[i]);
  }
  return ray;
}

/** \return whether anything was cut off */
bool cut(const Point& from, Point& to, long double range)
{
  const long double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  if (length <= range) return false;
  for (std::size_t i = 0; i < 3; ++i) to[i] = from[i] + (to[i] - from[i]) * range / length;
  return true;
}
}  // namespace

DenseGrid::DenseGrid(double resolution, const KeyBox& box) : m_resolution(resolution), m_box(box)
{
  std::int64_t size = 1;
  for (std::size_t i = 0; i < 3; ++i) size *= box.high[i] - box.low[i] + 1;
  m_voxels.resize(static_cast<std::size_t>(size));
}

std::size_t DenseGrid::indexOf(const VoxelKey& voxel) const
{
  const std::array<std::int64_t, 3> keys{voxel.x, voxel.y, voxel.z};
  std::int64_t index = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (keys[i] < m_box.low[i] || keys[i] > m_box.high[i])
      throw std::out_of_range("a voxel outside of the dense grid");
    index = index * (m_box.high[i] - m_box.low[i] + 1) + keys[i] - m_box.low[i];
  }
  return static_cast<std::size_t>(index);
}

void DenseGrid::update(const VoxelKey& voxel, double probability, const voxel::RayParams& params)
{
  auto& logOdds = m_voxels.at(indexOf(voxel));
  const float sum =
      logOdds.value_or(0.0f) + static_cast<float>(std::log(probability / (1 - probability)));
  logOdds =
      std::clamp(sum, static_cast<float>(params.minLogOdds), static_cast<float>(params.maxLogOdds));
  ++updates;
}

void DenseGrid::insert(const std::vector<voxel::Ray>& many, const voxel::RayParams& params)
{
  for (const auto& ray : many)
  {
    const auto from = pointOf(ray.origin);
    auto to = pointOf(ray.end);
    if (!from || !to)
    {
      ++notFinite;
      continue;
    }
    const bool isCut = params.maxRange > 0 && cut(*from, *to, params.maxRange);
    const auto atEnd = isCut ? voxel::RayEnd::Clear : ray.atEnd;
    const GridRay units = unitsOf(*from, *to, m_resolution);
    const auto voxels = voxelsOnRay(units, boxOf(units));
    for (std::size_t v = 0; v + 1 < voxels.size(); ++v) update(voxels[v], params.probMiss, params);
    if (atEnd != voxel::RayEnd::Keep)
      update(voxels.back(), atEnd == voxel::RayEnd::Hit ? params.probHit : params.probMiss, params);
    ++rays;
  }
}

}  // namespace mrpt_mapconv::oracle
