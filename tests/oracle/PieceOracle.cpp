#include "PieceOracle.h"

#include <algorithm>
#include <cmath>

#include "Shares.h"

namespace mrpt_mapconv::oracle
{
using mrpt::math::TPoint3D;

PieceOracle::PieceOracle(const DenseMap& map, const freespace::ConversionParams& conversion,
                         freespace::Robot robot, double heightOffset)
    : m_map(map), m_conversion(conversion), m_bodyLow(0), m_bodyHigh(0)
{
  if (robot == freespace::Robot::Aerial) return;
  m_bodyLow = std::max(conversion.maxStep, map.resolution) - heightOffset;
  m_bodyHigh = conversion.minClearance - heightOffset;
}

bool PieceOracle::crossesOccupied(const TPoint3D& from, const TPoint3D& to) const
{
  constexpr double kTouch = 1e-5;  // m, of heights
  const double res = m_map.resolution;
  if (m_bodyLow > m_bodyHigh) return false;
  for (int iy = 0; iy < m_map.ny; ++iy)
    for (int ix = 0; ix < m_map.nx; ++ix)
      for (int iz = 0; iz < m_map.nz; ++iz)
      {
        if (m_map.at(ix, iy, iz) != Voxel::Occupied) continue;
        const int kx = m_map.x0 + ix, ky = m_map.y0 + iy, kz = m_map.z0 + iz;
        Shares shares;
        shares.cut(from.x, to.x, kx * res, (kx + 1) * res);
        shares.cut(from.y, to.y, ky * res, (ky + 1) * res);
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        if (shares.end < shares.begin) continue;
        if (length > 0 && (shares.end - shares.begin) * length <= 1e-6 * res) continue;
        const double a = from.z + shares.begin * (to.z - from.z);
        const double b = from.z + shares.end * (to.z - from.z);
        if (std::max(a, b) + m_bodyHigh > kz * res + kTouch &&
            std::min(a, b) + m_bodyLow < (kz + 1) * res - kTouch)
          return true;
      }
  return false;
}

bool PieceOracle::stepTooHigh(double fromZ, double toZ, double distance) const
{
  return std::abs(toZ - fromZ) >
         std::max({m_conversion.maxStep, m_map.resolution,
                   m_conversion.maxSlope * std::max(distance, m_map.resolution)}) +
             1e-5;
}

}  // namespace mrpt_mapconv::oracle
