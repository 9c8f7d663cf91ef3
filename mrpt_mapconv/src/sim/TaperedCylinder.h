#pragma once

#include <mrpt_mapconv/sim/Primitive.h>

#include <array>
#include <optional>

namespace mrpt_mapconv::sim
{
/** A round body between two flat ends, in any direction: a trunk, standing or lying. */
class TaperedCylinder : public CurvedSurface
{
 public:
  /** An end: the middle of a disc across the axis. */
  struct End
  {
    mrpt::math::TPoint3D middle;  //!< [m]
    double radius = 0;            //!< [m], > 0
  };
  /** \param from,to at different places */
  TaperedCylinder(const End& from, const End& to);

  Footprint footprint() const;
  void appendMesh(Mesh& mesh) const;
  void appendSolids(double x, double y, std::vector<Solid>& solids) const;

  std::array<mrpt::math::TPoint3D, 2> bounds() const override;
  std::optional<Meeting> meet(const mrpt::math::TPoint3D& origin,
                              const mrpt::math::TVector3D& direction, double minRange,
                              double maxRange) const override;

 private:
  /** A straight line as seen from the axis, its zero near the body. */
  struct Line;

  /** Where a line enters the body and where it leaves it; none: it does not. */
  std::optional<std::array<Meeting, 2>> crossings(const mrpt::math::TPoint3D& origin,
                                                  const mrpt::math::TVector3D& direction) const;
  void meetEnds(const Line& line, std::vector<Meeting>& found) const;
  void meetWall(const Line& line, std::vector<Meeting>& found) const;

  End m_from, m_to;
  mrpt::math::TVector3D m_axis;  // of length 1
  double m_length, m_taper;      // of the radius, to a metre of the axis
};

}  // namespace mrpt_mapconv::sim
