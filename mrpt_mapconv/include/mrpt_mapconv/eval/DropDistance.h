#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/eval/CellMask.h>

#include <vector>

namespace mrpt_mapconv::eval
{
/** How near places come to drops: to the squares of cells that lie lower than the place. */
class DropDistance
{
 public:
  /** \param floor heights [m], NaN where unknown; it must outlive this
   * \param below which cells may be those at a drop's foot, on the floor's frame; see lowerEdges()
   * \param drop [m] */
  DropDistance(const grid::Layer<float>& floor, const CellMask& below, double drop);

  /** Distance from a place to the nearest of these cells whose floor lies more than `drop` below
   * that at the place [m]; infinite if there is none, or if the place has no floor. */
  double to(const mrpt::math::TPoint2D& place) const;

 private:
  struct Foot
  {
    mrpt::math::TPoint2D centre;  //!< [m]
    double floor;                 //!< [m]
  };

  const grid::Layer<float>& m_floor;
  double m_drop;
  std::vector<Foot> m_feet;
};

}  // namespace mrpt_mapconv::eval
