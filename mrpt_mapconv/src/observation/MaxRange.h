#pragma once

#include <mrpt_mapconv/observation/SensorPoints.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace mrpt_mapconv::observation
{
/** Tells returns from beams that met nothing: many drivers report those at the sensor's maximum
 * range, or beyond it. */
class MaxRange
{
 public:
  /** \param limit [m]; none if it is no number > 0
   * \param unit in which the sensor counts ranges [m]: half of it is lost to rounding */
  explicit MaxRange(double limit, double unit = 0)
      : m_limit(limit), m_from(limit - std::max(0.5 * unit, kSlack * limit))
  {
  }

  bool isSet() const { return m_limit > 0 && std::isfinite(m_limit); }
  /** The shortest range that says that nothing was met, if it is set. */
  double from() const { return m_from; }
  /** Whether a range, a finite one, says that nothing was met. */
  bool isReachedBy(double range) const
  {
    return isSet() && std::isfinite(range) && range >= m_from;
  }
  /** The range up to which a beam says something. */
  double cut(double range) const { return isReachedBy(range) ? m_limit : range; }

  /** Moves the points that are none over to the beams without return.
   * \param rangeOf a point's range as the sensor counts it [m] */
  template <class RangeOf>
  void sort(SensorPoints& scan, const RangeOf& rangeOf) const
  {
    const auto isNone = [&](const mrpt::math::TPoint3Df& point)
    {
      const double range = rangeOf(point);
      if (!isReachedBy(range)) return false;
      scan.noReturns.push_back(point * static_cast<float>(m_limit / range));
      return true;
    };
    auto& points = scan.points;
    points.erase(std::remove_if(points.begin(), points.end(), isNone), points.end());
  }

 private:
  static constexpr double kSlack = 1e-6;  // of the limit: ranges are floats
  double m_limit, m_from;
};

}  // namespace mrpt_mapconv::observation
