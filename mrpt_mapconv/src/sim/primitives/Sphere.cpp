#include <cmath>
#include <limits>

#include "../Ellipsoid.h"
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
    Ellipsoid(m_centre, m_radius, m_radius).appendMesh(mesh);
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
