#pragma once

#include <mrpt_mapconv/sim/Primitive.h>

#include "Ellipsoid.h"

namespace mrpt_mapconv::sim
{
/** How dense leaves are, and what the truth says of them. */
struct Leaves
{
  double density = 0;  //!< that a ray meets on a metre, in the mean [1/m]; > 0
  bool solid = false;  //!< the truth counts all of the volume as solid, else none

  /** Reads keys of these names. */
  static Leaves read(params::StrictSection& section);
};

/** A tree's crown: leaves in an ellipsoid. */
class Crown : public Primitive, public Foliage
{
 public:
  Crown(const Ellipsoid& body, const Leaves& leaves) : m_body(body), m_leaves(leaves) {}

  Footprint footprint() const override { return m_body.footprint(); }
  void appendMesh(Mesh& mesh) const override { m_body.appendMesh(mesh); }
  const Foliage* foliage() const override { return this; }
  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    if (m_leaves.solid) m_body.appendSolids(x, y, solids);
  }

  std::size_t parts() const override { return 1; }
  std::array<mrpt::math::TPoint3D, 2> boundsOf(std::size_t) const override
  {
    return m_body.bounds();
  }
  std::optional<Stretch> inside(std::size_t, const mrpt::math::TPoint3D& origin,
                                const mrpt::math::TVector3D& direction) const override
  {
    return m_body.inside(origin, direction);
  }
  double density() const override { return m_leaves.density; }

 private:
  Ellipsoid m_body;
  Leaves m_leaves;
};

/** Where a crown is above its tree's foot. */
struct CrownShape
{
  double bottom = 0, top = 0;  //!< above the ground [m], bottom < top
  double radius = 0;           //!< [m], > 0
};

/** \param foot of its tree [m] */
std::unique_ptr<Primitive> crownOver(const mrpt::math::TPoint3D& foot, const CrownShape& shape,
                                     const Leaves& leaves);

}  // namespace mrpt_mapconv::sim
