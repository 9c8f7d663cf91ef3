#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/eval/CellMask.h>

#include <vector>

namespace mrpt_mapconv::eval
{
/** How near places come to the cells of a mask. */
class CellDistance
{
 public:
  explicit CellDistance(const CellMask& mask);

  /** Distance from a place to the nearest cell's square [m]: 0 in one of them, infinite if there
   * are none. Takes a time in proportion to the number of cells. */
  double to(const mrpt::math::TPoint2D& place) const;

 private:
  double m_half;                                //!< side of a cell, halved [m]
  std::vector<mrpt::math::TPoint2D> m_centres;  //!< of the mask's cells [m]
};

}  // namespace mrpt_mapconv::eval
