#pragma once

#include <mrpt_mapconv/sim/Primitive.h>

namespace mrpt_mapconv::sim
{
/** An upright cylinder with its bottom and top. */
class UprightCylinder : public CurvedSurface
{
 public:
  /** \param base centre of its lower face [m] \param radius, height [m], > 0 */
  UprightCylinder(const mrpt::math::TPoint3D& base, double radius, double height);

  Footprint footprint() const;
  void appendMesh(Mesh& mesh) const;
  void appendSolids(double x, double y, std::vector<Solid>& solids) const;

  std::array<mrpt::math::TPoint3D, 2> bounds() const override;
  std::optional<Meeting> meet(const mrpt::math::TPoint3D& origin,
                              const mrpt::math::TVector3D& direction, double minRange,
                              double maxRange) const override;

 private:
  std::optional<Meeting> meetWall(const mrpt::math::TPoint3D& origin,
                                  const mrpt::math::TVector3D& direction, double minRange,
                                  double maxRange) const;
  std::optional<Meeting> meetCap(bool upper, const mrpt::math::TPoint3D& origin,
                                 const mrpt::math::TVector3D& direction, double minRange,
                                 double maxRange) const;

  mrpt::math::TPoint3D m_base;
  double m_radius, m_top;
};

}  // namespace mrpt_mapconv::sim
