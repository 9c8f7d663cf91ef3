#include "UprightCylinder.h"

#include <cmath>

#include "MeshBuilder.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

UprightCylinder::UprightCylinder(const TPoint3D& base, double radius, double height)
    : m_base(base), m_radius(radius), m_top(base.z + height)
{
}

Footprint UprightCylinder::footprint() const
{
  return {m_base.x - m_radius, m_base.y - m_radius, m_base.x + m_radius, m_base.y + m_radius};
}

void UprightCylinder::appendMesh(Mesh& mesh) const
{
  constexpr int kSectors = 32;
  constexpr double kPi = 3.14159265358979323846;
  std::vector<MeshBuilder::Point2> circle;
  for (int sector = 0; sector < kSectors; ++sector)
  {
    const double around = 2 * kPi * sector / kSectors;
    circle.push_back(
        {m_base.x + m_radius * std::cos(around), m_base.y + m_radius * std::sin(around)});
  }
  MeshBuilder(mesh).prism(circle, m_base.z, m_top);
}

std::array<TPoint3D, 2> UprightCylinder::bounds() const
{
  return {TPoint3D(m_base.x - m_radius, m_base.y - m_radius, m_base.z),
          TPoint3D(m_base.x + m_radius, m_base.y + m_radius, m_top)};
}

std::optional<CurvedSurface::Meeting> UprightCylinder::meet(const TPoint3D& origin,
                                                            const TVector3D& direction,
                                                            double minRange, double maxRange) const
{
  std::optional<Meeting> first = meetWall(origin, direction, minRange, maxRange);
  for (const bool upper : {false, true})
  {
    const auto cap = meetCap(upper, origin, direction, minRange, first ? first->range : maxRange);
    if (cap) first = cap;
  }
  return first;
}

void UprightCylinder::appendSolids(double x, double y, std::vector<Solid>& solids) const
{
  if (std::hypot(x - m_base.x, y - m_base.y) <= m_radius) solids.push_back({m_base.z, m_top, 0});
}

std::optional<CurvedSurface::Meeting> UprightCylinder::meetWall(const TPoint3D& origin,
                                                                const TVector3D& direction,
                                                                double minRange,
                                                                double maxRange) const
{
  // in the horizontal plane, where the ray's parameter is its horizontal length
  const double speed = std::hypot(direction.x, direction.y);
  if (speed == 0) return {};
  const double ux = direction.x / speed, uy = direction.y / speed;
  const double cx = m_base.x - origin.x, cy = m_base.y - origin.y;
  const double aside = cx * uy - cy * ux;
  const double halfSquare = m_radius * m_radius - aside * aside;
  if (halfSquare < 0) return {};
  const double closest = cx * ux + cy * uy, half = std::sqrt(halfSquare);
  for (const double along : {closest - half, closest + half})
  {
    const double range = along / speed, z = origin.z + range * direction.z;
    if (range >= minRange && range <= maxRange && z >= m_base.z && z <= m_top)
      return Meeting{range, {along * ux - cx, along * uy - cy, 0}};
  }
  return {};
}

std::optional<CurvedSurface::Meeting> UprightCylinder::meetCap(bool upper, const TPoint3D& origin,
                                                               const TVector3D& direction,
                                                               double minRange,
                                                               double maxRange) const
{
  if (direction.z == 0) return {};
  const double range = ((upper ? m_top : m_base.z) - origin.z) / direction.z;
  if (!(range >= minRange && range <= maxRange)) return {};
  const double x = origin.x + range * direction.x, y = origin.y + range * direction.y;
  if (std::hypot(x - m_base.x, y - m_base.y) > m_radius) return {};
  return Meeting{range, {0, 0, upper ? 1.0 : -1.0}};
}

}  // namespace mrpt_mapconv::sim
