#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::path
{
/** How much the height of a ground robot's path may change between two neighbouring points:
 * max(maxStep, one voxel, maxSlope · their horizontal distance). */
class StepLimit
{
 public:
  /** \param resolution of the layers [m] */
  StepLimit(const freespace::ConversionParams& conversion, double resolution)
      : m_least(std::max(conversion.maxStep, resolution)), m_slope(conversion.maxSlope)
  {
  }

  double least() const { return m_least; }  //!< between points at one place [m]
  /** \param distance between the points, horizontally [m] \return [m] */
  double at(double distance) const { return std::max(m_least, m_slope * distance); }

  /** Whether a change of height is too high. \param change, distance [m] */
  bool forbids(double change, double distance) const
  {
    constexpr double kSlack = 1e-5;  // m: layers hold heights as floats
    return std::abs(change) > at(distance) + kSlack;
  }

 private:
  double m_least, m_slope;
};

}  // namespace mrpt_mapconv::path
