#include "Ellipsoid.h"

#include <cmath>
#include <limits>

#include "MeshBuilder.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

Footprint Ellipsoid::footprint() const
{
  return {m_centre.x - m_radius, m_centre.y - m_radius, m_centre.x + m_radius,
          m_centre.y + m_radius};
}

std::array<TPoint3D, 2> Ellipsoid::bounds() const
{
  return {TPoint3D(m_centre.x - m_radius, m_centre.y - m_radius, m_centre.z - m_half),
          TPoint3D(m_centre.x + m_radius, m_centre.y + m_radius, m_centre.z + m_half)};
}

void Ellipsoid::appendMesh(Mesh& mesh) const
{
  constexpr std::uint32_t kRings = 16, kSectors = 32;
  constexpr double kPi = 3.14159265358979323846;
  MeshBuilder build(mesh);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t ring = 0; ring <= kRings; ++ring)
    for (std::uint32_t sector = 0; sector < kSectors; ++sector)
    {
      const double polar = kPi * ring / kRings, around = 2 * kPi * sector / kSectors;
      const double across = m_radius * std::sin(polar);
      build.vertex(m_centre.x + across * std::cos(around), m_centre.y + across * std::sin(around),
                   m_centre.z + m_half * std::cos(polar));
    }
  for (std::uint32_t ring = 0; ring < kRings; ++ring)
    for (std::uint32_t sector = 0; sector < kSectors; ++sector)
    {
      const std::uint32_t a = first + ring * kSectors, next = (sector + 1) % kSectors;
      build.quad(a + sector, a + kSectors + sector, a + kSectors + next, a + next);
    }
}

void Ellipsoid::appendSolids(double x, double y, std::vector<Solid>& solids) const
{
  const double distance = std::hypot(x - m_centre.x, y - m_centre.y);
  if (distance > m_radius) return;
  const double across = std::sqrt(m_radius * m_radius - distance * distance);
  const double half = across * (m_half / m_radius);
  const double slope = across > 0 ? distance / across * (m_half / m_radius)
                                  : std::numeric_limits<double>::infinity();
  solids.push_back({m_centre.z - half, m_centre.z + half, slope});
}

std::optional<Stretch> Ellipsoid::inside(const TPoint3D& origin, const TVector3D& direction) const
{
  // where it is a sphere of radius 1 about 0
  const auto scaled = [this](double x, double y, double z)
  { return TVector3D(x / m_radius, y / m_radius, z / m_half); };
  const TVector3D o = scaled(origin.x - m_centre.x, origin.y - m_centre.y, origin.z - m_centre.z);
  const TVector3D d = scaled(direction.x, direction.y, direction.z);
  const double a = d.x * d.x + d.y * d.y + d.z * d.z;
  const double middle = -(o.x * d.x + o.y * d.y + o.z * d.z) / a;
  // from the centre to the ray's nearest point: small numbers, so that far rays lose nothing
  const TVector3D nearest = o + d * middle;
  const double square = 1 - (nearest.x * nearest.x + nearest.y * nearest.y + nearest.z * nearest.z);
  if (square < 0) return {};
  const double half = std::sqrt(square / a);
  return Stretch{middle - half, middle + half};
}

}  // namespace mrpt_mapconv::sim
