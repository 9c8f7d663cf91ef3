#include <cmath>
#include <limits>

#include "../MeshBuilder.h"
#include "../SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

/** centre: x y z [m]; radius [m]. */
class Sphere : public Primitive, public CurvedSurface
{
 public:
  Sphere(const TPoint3D& centre, double radius) : m_centre(centre), m_radius(radius) {}

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    const TPoint3D centre = readPoint3D(section, "centre");
    return std::make_unique<Sphere>(centre, readPositive(section, "radius"));
  }

  Footprint footprint() const override
  {
    return {m_centre.x - m_radius, m_centre.y - m_radius, m_centre.x + m_radius,
            m_centre.y + m_radius};
  }

  void appendMesh(Mesh& mesh) const override
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
                     m_centre.z + m_radius * std::cos(polar));
      }
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
      for (std::uint32_t sector = 0; sector < kSectors; ++sector)
      {
        const std::uint32_t a = first + ring * kSectors, next = (sector + 1) % kSectors;
        build.quad(a + sector, a + kSectors + sector, a + kSectors + next, a + next);
      }
  }

  const CurvedSurface* curved() const override { return this; }

  std::array<TPoint3D, 2> bounds() const override
  {
    const auto corner = [this](double r)
    { return TPoint3D(m_centre.x + r, m_centre.y + r, m_centre.z + r); };
    return {corner(-m_radius), corner(m_radius)};
  }

  std::optional<Meeting> meet(const TPoint3D& origin, const TVector3D& direction, double minRange,
                              double maxRange) const override
  {
    const double cx = m_centre.x - origin.x, cy = m_centre.y - origin.y, cz = m_centre.z - origin.z;
    const double ux = direction.x, uy = direction.y, uz = direction.z;
    const double closest = cx * ux + cy * uy + cz * uz;
    // from the centre to the ray's nearest point: small numbers, so that far rays lose nothing
    const double ax = closest * ux - cx, ay = closest * uy - cy, az = closest * uz - cz;
    const double halfSquare = m_radius * m_radius - (ax * ax + ay * ay + az * az);
    if (halfSquare < 0) return {};
    const double half = std::sqrt(halfSquare);
    for (const double range : {closest - half, closest + half})
      if (range >= minRange && range <= maxRange)
        return Meeting{range, {range * ux - cx, range * uy - cy, range * uz - cz}};
    return {};
  }

  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    const double distance = std::hypot(x - m_centre.x, y - m_centre.y);
    if (distance > m_radius) return;
    const double half = std::sqrt(m_radius * m_radius - distance * distance);
    const double slope = half > 0 ? distance / half : std::numeric_limits<double>::infinity();
    solids.push_back({m_centre.z - half, m_centre.z + half, slope});
  }

 private:
  TPoint3D m_centre;
  double m_radius;
};

const PrimitiveKind kKind("sphere", Sphere::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
