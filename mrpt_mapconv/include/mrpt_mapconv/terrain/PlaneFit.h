#pragma once

#include <cstdint>

namespace mrpt_mapconv::terrain
{
/** Heights are whole multiples of this [m], so that sums of them are exact. */
constexpr double kHeightUnit = 1.0 / 32768;

/** A plane over cells: height = height + slopeX·(kx − originX) + slopeY·(ky − originY). */
struct Plane
{
  std::int32_t originX = 0, originY = 0;  //!< key of a cell
  double height = 0;                      //!< there [kHeightUnit]
  double slopeX = 0, slopeY = 0;          //!< [kHeightUnit per cell]

  /** At the centre of a cell [kHeightUnit]. */
  double at(std::int32_t kx, std::int32_t ky) const
  {
    return (height + slopeY * static_cast<double>(ky - originY)) +
           slopeX * static_cast<double>(kx - originX);
  }
};

__extension__ using Int128 = __int128;

/** The moments of cells, as whole numbers relative to an origin: adding and taking away cells in
 * any order gives the same. */
class PlaneMoments
{
 public:
  PlaneMoments() = default;
  /** \param z of the origin [kHeightUnit] */
  PlaneMoments(std::int32_t kx, std::int32_t ky, std::int32_t z) : m_x(kx), m_y(ky), m_z(z) {}

  void add(std::int32_t kx, std::int32_t ky, std::int32_t z) { change(kx, ky, z, 1); }
  void remove(std::int32_t kx, std::int32_t ky, std::int32_t z) { change(kx, ky, z, -1); }
  /** Moves the cells of another one in, whatever its origin. */
  void add(const PlaneMoments& other) { addTimes(other, 1); }
  /** Takes the cells of another one out. */
  void subtract(const PlaneMoments& other) { addTimes(other, -1); }

  std::int64_t cells() const { return m_n; }
  std::int32_t originX() const { return m_x; }
  std::int32_t originY() const { return m_y; }
  std::int32_t originZ() const { return m_z; }
  /** False if all cells lie on one line. */
  bool spans() const;
  /** The least-squares plane of the cells, which must span(). */
  Plane fit() const;
  /** Root mean square of the cells' vertical differences to fit() [kHeightUnit]. */
  double rms() const;
  /** Mean key of the cells. */
  double meanX() const { return m_x + static_cast<double>(m_sx) / static_cast<double>(m_n); }
  double meanY() const { return m_y + static_cast<double>(m_sy) / static_cast<double>(m_n); }
  /** The smaller side of a rectangle of evenly spread cells, however turned, with their variances
   * and covariance. */
  double narrowness() const;
  /** Half the sides of an upright rectangle of evenly spread cells with the variances of these. */
  double halfWidthX() const { return halfWidth(m_sxx, m_sx); }
  double halfWidthY() const { return halfWidth(m_syy, m_sy); }

 private:
  double halfWidth(std::int64_t squares, std::int64_t sum) const;
  void addTimes(const PlaneMoments& o, std::int64_t times);
  void change(std::int32_t kx, std::int32_t ky, std::int32_t z, std::int64_t sign)
  {
    const std::int64_t x = std::int64_t{kx} - m_x, y = std::int64_t{ky} - m_y,
                       h = std::int64_t{z} - m_z;
    m_n += sign;
    m_sx += sign * x;
    m_sy += sign * y;
    m_sz += sign * h;
    m_sxx += sign * x * x;
    m_sxy += sign * x * y;
    m_syy += sign * y * y;
    m_sxz += sign * x * h;
    m_syz += sign * y * h;
    m_szz += Int128{sign} * h * h;
  }

  std::int32_t m_x = 0, m_y = 0, m_z = 0;
  std::int64_t m_n = 0, m_sx = 0, m_sy = 0, m_sz = 0, m_sxx = 0, m_sxy = 0, m_syy = 0;
  Int128 m_sxz = 0, m_syz = 0, m_szz = 0;
};

}  // namespace mrpt_mapconv::terrain
