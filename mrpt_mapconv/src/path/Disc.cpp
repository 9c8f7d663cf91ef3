#include "Disc.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::path
{
namespace
{
constexpr double kSlack = 1e-9;  // of a cell: a square that the sphere touches on paper is reached

/** Further than the frame is wide nothing but the outside is left to see. */
std::int32_t reachOf(const grid::GridFrame& frame, double radius)
{
  const double cells = std::floor(radius / frame.resolution + 2 * kSlack) + 1;
  return static_cast<std::int32_t>(
      std::min(cells, static_cast<double>(std::max(frame.width, frame.height))));
}
}  // namespace

Disc::Disc(const grid::GridFrame& frame, double radius)
    : m_resolution(frame.resolution),
      m_radius(radius),
      m_radiusSq(radius * radius),
      m_limitSq(std::pow(radius + kSlack * frame.resolution, 2)),
      m_reach(reachOf(frame, radius)),
      m_dxSq(2 * static_cast<std::size_t>(m_reach) + 1),
      m_dySq(m_dxSq.size())
{
}

void Disc::moveTo(double x, double y, std::int32_t kx, std::int32_t ky)
{
  m_kxFirst = kx - m_reach;
  m_kyFirst = ky - m_reach;
  setDistances(x, kx, m_dxSq);
  setDistances(y, ky, m_dySq);
}

void Disc::setDistances(double x, std::int32_t key, std::vector<double>& squares) const
{
  double* centre = squares.data() + m_reach;
  *centre = 0;
  for (std::int32_t i = 1; i <= m_reach; ++i)
  {
    const double above = (key + i) * m_resolution - x, below = x - (key - i + 1) * m_resolution;
    centre[i] = above * above;
    centre[-i] = below * below;
  }
}

}  // namespace mrpt_mapconv::path
