#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose3D.h>
#include <mrpt_mapconv/sim/Primitive.h>

#include <vector>

#include "Block.h"
#include "SectionKeys.h"

namespace mrpt_mapconv::sim
{
/** A piece of furniture: upright boxes that form one body. It stands on a floor and may be turned
 * about its middle; its parts are given in its own frame, whose origin lies on the floor in that
 * middle. */
class Furniture : public Primitive
{
 public:
  Footprint footprint() const override;
  void appendMesh(Mesh& mesh) const override;
  void appendSolids(double x, double y, std::vector<Solid>& solids) const override;

 protected:
  /** Reads what all furniture has: base, the floor's z [m], and yaw [degrees]; default 0.
   * \param middle x y [m] */
  Furniture(params::StrictSection& section, const mrpt::math::TPoint2D& middle);

  /** \param part its corners in the furniture's own frame [m] */
  void add(const Corners& part);
  /** Four legs in the corners of an outline about the middle.
   * \param size of the outline, x y [m] \param leg side of a leg [m] \param top of the legs [m] */
  void addLegs(const mrpt::math::TPoint2D& size, double leg, double top);

 private:
  mrpt::math::TPose3D m_pose;  //!< own frame -> map
  std::vector<Block> m_parts;
};

}  // namespace mrpt_mapconv::sim
