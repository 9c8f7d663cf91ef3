#pragma once

#include <mrpt_mapconv/sim/Primitive.h>

#include <array>
#include <optional>

namespace mrpt_mapconv::sim
{
/** An upright body that is round from above and an ellipse from aside. */
class Ellipsoid
{
 public:
  /** \param radius around the vertical axis [m] \param half of its height [m] */
  Ellipsoid(const mrpt::math::TPoint3D& centre, double radius, double half)
      : m_centre(centre), m_radius(radius), m_half(half)
  {
  }

  Footprint footprint() const;
  std::array<mrpt::math::TPoint3D, 2> bounds() const;
  void appendMesh(Mesh& mesh) const;
  void appendSolids(double x, double y, std::vector<Solid>& solids) const;
  /** \param direction of length 1 */
  std::optional<Stretch> inside(const mrpt::math::TPoint3D& origin,
                                const mrpt::math::TVector3D& direction) const;

 private:
  mrpt::math::TPoint3D m_centre;
  double m_radius, m_half;
};

}  // namespace mrpt_mapconv::sim
