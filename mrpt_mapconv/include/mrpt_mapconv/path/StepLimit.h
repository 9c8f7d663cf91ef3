#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::path
{
/** How much the height of a ground robot's path may change between two neighbouring points:
 * max(maxStep, one voxel, maxSlope · their horizontal distance); a maxStep that is off adds
 * nothing.
 *
 * A distance of less than a cell counts as one: floors change from cell to cell, so how near to the
 * border between two the points lie is of no account. */
class StepLimit
{
 public:
  /** \param resolution of the layers [m] */
  StepLimit(const freespace::ConversionParams& conversion, double resolution)
      : m_cell(resolution),
        m_least(std::max(conversion.looksForSteps() ? conversion.stepHeight(resolution) : 0,
                         resolution)),
        m_slope(conversion.maxSlope)
  {
  }

  double least() const { return m_least; }  //!< max(maxStep, one voxel) [m]
  /** The distance that counts. \param distance between the points, horizontally [m] \return [m] */
  double counted(double distance) const { return std::max(distance, m_cell); }
  /** \param distance as for counted() \return [m] */
  double at(double distance) const { return std::max(m_least, m_slope * counted(distance)); }

  /** Whether a change of height is too high. \param change, distance [m] */
  bool forbids(double change, double distance) const
  {
    constexpr double kSlack = 1e-5;  // m: layers hold heights as floats
    return std::abs(change) > at(distance) + kSlack;
  }

 private:
  double m_cell, m_least, m_slope;
};

}  // namespace mrpt_mapconv::path
