#include "LineReach.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::scan
{
void LineReach::clear()
{
  m_near = -1;
  m_bound.assign(kSectors, -1);
}

void LineReach::add(const SensorPlace& place, std::int32_t ix, std::int32_t iy)
{
  const double x = ix + 0.5 - place.fx, y = iy + 0.5 - place.fy;
  const double distance = std::sqrt(x * x + y * y);
  if (distance < 2)
  {
    m_near = std::max(m_near, distance);
    return;
  }
  constexpr double kHalfDiagonal = 0.7072, kArcOverSine = 1.03;  // up to sine 0.36
  const double half = kArcOverSine * kHalfDiagonal / distance;
  const double middle = diamondAngleOf(x, y), perSector = kSectors / 4.0;
  const auto first = static_cast<int>(std::floor((middle - half) * perSector));
  const auto last = static_cast<int>(std::floor((middle + half) * perSector));
  for (int sector = first; sector <= last; ++sector)
  {
    double& bound = m_bound[static_cast<std::size_t>(sector & (kSectors - 1))];
    bound = std::max(bound, distance);
  }
}

double LineReach::of(const Line& line) const
{
  const auto sector = static_cast<int>(line.diamondAngle * (kSectors / 4.0)) & (kSectors - 1);
  return std::max(m_near, m_bound[static_cast<std::size_t>(sector)]);
}

}  // namespace mrpt_mapconv::scan
