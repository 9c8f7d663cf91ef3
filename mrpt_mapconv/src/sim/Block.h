#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/sim/Primitive.h>

namespace mrpt_mapconv::sim
{
/** An upright box that may be turned about the vertical axis. */
class Block
{
 public:
  /** \param centre [m] \param size along its own axes [m], > 0 \param yaw [rad] */
  Block(const mrpt::math::TPoint3D& centre, const mrpt::math::TPoint3D& size, double yaw);

  Footprint footprint() const;
  void appendMesh(Mesh& mesh) const;
  void appendSolids(double x, double y, std::vector<Solid>& solids) const;

 private:
  mrpt::math::TPoint3D m_centre, m_half;
  double m_cos, m_sin;
};

}  // namespace mrpt_mapconv::sim
