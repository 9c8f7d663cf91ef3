#include <mrpt_mapconv/terrain/PlaneFit.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::terrain
{
namespace
{
/** Moments about the mean, times the square of the number of cells: whole numbers. */
struct Central
{
  double xx, xy, yy, xz, yz, zz;
};
}  // namespace

void PlaneMoments::addTimes(const PlaneMoments& o, std::int64_t times)
{
  // x of the other about this origin is x + dx
  const std::int64_t dx = std::int64_t{o.m_x} - m_x, dy = std::int64_t{o.m_y} - m_y,
                     dz = std::int64_t{o.m_z} - m_z;
  m_n += times * o.m_n;
  m_sx += times * (o.m_sx + dx * o.m_n);
  m_sy += times * (o.m_sy + dy * o.m_n);
  m_sz += times * (o.m_sz + dz * o.m_n);
  m_sxx += times * (o.m_sxx + 2 * dx * o.m_sx + dx * dx * o.m_n);
  m_syy += times * (o.m_syy + 2 * dy * o.m_sy + dy * dy * o.m_n);
  m_sxy += times * (o.m_sxy + dx * o.m_sy + dy * o.m_sx + dx * dy * o.m_n);
  m_sxz += times * (o.m_sxz + Int128{dx} * o.m_sz + Int128{dz} * o.m_sx + Int128{dx} * dz * o.m_n);
  m_syz += times * (o.m_syz + Int128{dy} * o.m_sz + Int128{dz} * o.m_sy + Int128{dy} * dz * o.m_n);
  m_szz += times * (o.m_szz + Int128{2 * dz} * o.m_sz + Int128{dz} * dz * o.m_n);
}

double PlaneMoments::halfWidth(std::int64_t squares, std::int64_t sum) const
{
  const auto n = static_cast<double>(m_n);
  const auto spread = static_cast<double>(Int128{m_n} * squares - Int128{sum} * sum);
  return std::sqrt(3 * std::max(0.0, spread)) / n;
}

double PlaneMoments::narrowness() const
{
  const Int128 n = m_n;
  const auto xx = static_cast<double>(n * m_sxx - Int128{m_sx} * m_sx),
             yy = static_cast<double>(n * m_syy - Int128{m_sy} * m_sy),
             xy = static_cast<double>(n * m_sxy - Int128{m_sx} * m_sy);
  const double least = (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy);
  // a row of w cells has the variance (w² − 1) / 12
  const auto cells = static_cast<double>(m_n);
  return std::sqrt(12 * std::max(0.0, least) / (cells * cells) + 1);
}

bool PlaneMoments::spans() const
{
  if (m_n < 3) return false;
  const Int128 n = m_n;
  const Int128 xx = n * m_sxx - Int128{m_sx} * m_sx, yy = n * m_syy - Int128{m_sy} * m_sy,
               xy = n * m_sxy - Int128{m_sx} * m_sy;
  // a product of these would overflow; rounding cannot make 0 of what lies two cells wide
  const auto a = static_cast<long double>(xx), b = static_cast<long double>(yy),
             c = static_cast<long double>(xy);
  return a * b - c * c > 1e-12L * a * b;
}

namespace
{
struct Sums
{
  Int128 n, x, y, z, xx, xy, yy, xz, yz, zz;

  Central central() const
  {
    const auto of = [this](Int128 ab, Int128 a, Int128 b)
    { return static_cast<double>(n * ab - a * b); };
    return {of(xx, x, x), of(xy, x, y), of(yy, y, y), of(xz, x, z), of(yz, y, z), of(zz, z, z)};
  }
};
}  // namespace

Plane PlaneMoments::fit() const
{
  const Central c = Sums{m_n, m_sx, m_sy, m_sz, m_sxx, m_sxy, m_syy, m_sxz, m_syz, m_szz}.central();
  const double det = c.xx * c.yy - c.xy * c.xy;
  Plane plane;
  plane.originX = m_x;
  plane.originY = m_y;
  plane.slopeX = (c.xz * c.yy - c.yz * c.xy) / det;
  plane.slopeY = (c.yz * c.xx - c.xz * c.xy) / det;
  const auto n = static_cast<double>(m_n);
  plane.height = m_z + (static_cast<double>(m_sz) - plane.slopeX * static_cast<double>(m_sx) -
                        plane.slopeY * static_cast<double>(m_sy)) /
                           n;
  return plane;
}

double PlaneMoments::rms() const
{
  const Central c = Sums{m_n, m_sx, m_sy, m_sz, m_sxx, m_sxy, m_syy, m_sxz, m_syz, m_szz}.central();
  const Plane plane = fit();
  const double squares = c.zz - plane.slopeX * c.xz - plane.slopeY * c.yz;
  return std::sqrt(std::max(0.0, squares)) / static_cast<double>(m_n);
}

}  // namespace mrpt_mapconv::terrain
