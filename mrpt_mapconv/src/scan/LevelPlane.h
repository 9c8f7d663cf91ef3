#pragma once

#include <cmath>

namespace mrpt_mapconv::scan
{
/** A plane that is level or nearly so: heights that change evenly with the place. */
struct LevelPlane
{
  double height = 0;              //!< at the origin [m]
  double slopeX = 0, slopeY = 0;  //!< along x and y

  double at(double x, double y) const { return height + slopeX * x + slopeY * y; }
};

/** Weighted least squares through points, with a pull towards level: a slope costs as much as if
 * each point had others 0.5 m to its sides that lie level. Points all in one direction thus give no
 * wild plane. Slopes above kSteepest are shortened to it. */
class LevelPlaneFit
{
 public:
  static constexpr double kSteepest = 0.1;

  void add(double x, double y, double z, double weight)
  {
    m_weight += weight;
    m_x += weight * x, m_y += weight * y, m_z += weight * z;
    m_xx += weight * x * x, m_xy += weight * x * y, m_yy += weight * y * y;
    m_xz += weight * x * z, m_yz += weight * y * z;
  }
  /** For at least one point. */
  LevelPlane plane() const
  {
    constexpr double kPullSq = 0.25;  // [m²]
    const double n = m_weight, x = m_x / n, y = m_y / n, z = m_z / n;
    const double xx = m_xx / n - x * x + kPullSq, yy = m_yy / n - y * y + kPullSq;
    const double xy = m_xy / n - x * y, xz = m_xz / n - x * z, yz = m_yz / n - y * z;
    const double det = xx * yy - xy * xy;
    double slopeX = (xz * yy - yz * xy) / det, slopeY = (yz * xx - xz * xy) / det;
    const double tooSteep = std::hypot(slopeX, slopeY) / kSteepest;
    if (tooSteep > 1) slopeX /= tooSteep, slopeY /= tooSteep;
    return {z - slopeX * x - slopeY * y, slopeX, slopeY};
  }

 private:
  double m_weight = 0, m_x = 0, m_y = 0, m_z = 0, m_xx = 0, m_xy = 0, m_yy = 0, m_xz = 0, m_yz = 0;
};

}  // namespace mrpt_mapconv::scan
