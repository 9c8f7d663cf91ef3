#include "PieceOracle.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "DenseOracle.h"
#include "Shares.h"

namespace mrpt_mapconv::oracle
{
using mrpt::math::TPoint3D;

namespace
{
/** The part of a straight piece in a column; nothing if it only touches it. */
std::optional<Shares> partIn(int kx, int ky, double res, const TPoint3D& from, const TPoint3D& to)
{
  Shares shares;
  shares.cut(from.x, to.x, kx * res, (kx + 1) * res);
  shares.cut(from.y, to.y, ky * res, (ky + 1) * res);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (shares.end < shares.begin) return std::nullopt;
  if (length > 0 && (shares.end - shares.begin) * length <= 1e-6 * res) return std::nullopt;
  return shares;
}
}  // namespace

PieceOracle::PieceOracle(const DenseMap& map, const freespace::ConversionParams& conversion,
                         freespace::Robot robot, double heightOffset)
    : m_map(map), m_conversion(conversion), m_bodyLow(0), m_bodyHigh(0)
{
  if (robot == freespace::Robot::Aerial) return;
  m_bodyLow = std::max(maxStepOf(conversion, map.resolution), map.resolution) - heightOffset;
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
        const std::optional<Shares> part = partIn(kx, ky, res, from, to);
        if (!part) continue;
        const double a = from.z + part->begin * (to.z - from.z);
        const double b = from.z + part->end * (to.z - from.z);
        if (std::max(a, b) + m_bodyHigh > kz * res + kTouch &&
            std::min(a, b) + m_bodyLow < (kz + 1) * res - kTouch)
          return true;
      }
  return false;
}

bool PieceOracle::crossesUnseenGround(const freespace::Layers& layers, const TPoint3D& from,
                                      const TPoint3D& to) const
{
  const grid::GridFrame& frame = layers.frame();
  for (int iy = 0; iy < frame.height; ++iy)
    for (int ix = 0; ix < frame.width; ++ix)
      if (!std::isnan(layers.floor.at(ix, iy)) && std::isnan(layers.support.at(ix, iy)) &&
          partIn(frame.x0 + ix, frame.y0 + iy, frame.resolution, from, to))
        return true;
  return false;
}

bool PieceOracle::stepTooHigh(double fromZ, double toZ, double distance) const
{
  return std::abs(toZ - fromZ) >
         std::max({maxStepOf(m_conversion, m_map.resolution), m_map.resolution,
                   m_conversion.maxSlope * std::max(distance, m_map.resolution)}) +
             1e-5;
}

}  // namespace mrpt_mapconv::oracle
