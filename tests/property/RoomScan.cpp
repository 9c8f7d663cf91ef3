#include "RoomScan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mrpt_mapconv::test
{
namespace
{
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;

constexpr double kDegree = 3.14159265358979323846 / 180;

/** How far along a direction the two planes at low and high are, from in between. */
double rangeTo(double from, double d, double low, double high)
{
  if (d == 0) return std::numeric_limits<double>::infinity();
  return ((d > 0 ? high : low) - from) / d;
}

/** About normal, with standard deviation 1; the same numbers with every standard library. */
double error(Rng& rng)
{
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += uniform(rng, 0, 1);
  return sum;
}

class Caster
{
 public:
  Caster(const Room& room, const CPose3D& sensor, Rng& rng)
      : m_room(room), m_from(sensor.x(), sensor.y(), sensor.z()), m_rng(rng)
  {
  }

  /** Distance to the first thing that shows up. */
  double range(const TPoint3D& d)
  {
    const double x = rangeTo(m_from.x, d.x, m_room.xMin, m_room.xMax),
                 y = rangeTo(m_from.y, d.y, m_room.yMin, m_room.yMax),
                 z = rangeTo(m_from.z, d.z, 0, m_room.ceiling);
    const unsigned wall = x < y ? (d.x > 0 ? 1U : 2U) : (d.y > 0 ? 4U : 8U);
    const double toWall = std::min(x, y);
    if (!isSeenThrough(wall, m_from.z + toWall * d.z)) return std::min(toWall, z);
    const double margin = m_room.hallMargin;
    return std::min({rangeTo(m_from.x, d.x, m_room.xMin - margin, m_room.xMax + margin),
                     rangeTo(m_from.y, d.y, m_room.yMin - margin, m_room.yMax + margin), z});
  }

 private:
  bool isSeenThrough(unsigned wall, double height)
  {
    return (m_room.glass & wall) != 0 && height < m_room.lintel && uniform(m_rng, 0, 1) > 0.1;
  }

  const Room& m_room;
  const TPoint3D m_from;
  Rng& m_rng;
};
}  // namespace

std::vector<Lidar> commonLidars()
{
  const auto lidar = [](const char* name, double low, double high, int rings, int columns)
  { return Lidar{name, low * kDegree, high * kDegree, rings, columns, 360 * kDegree}; };
  std::vector<Lidar> all{lidar("16 rings, 15 degrees up", -15, 15, 16, 900),
                         lidar("32 rings, 15 degrees up", -25, 15, 32, 900),
                         lidar("64 rings, 22.5 degrees up", -22.5, 22.5, 64, 512),
                         lidar("128 rings, 45 degrees up", -45, 45, 128, 512),
                         lidar("40 rings, 60 degrees up", -7, 60, 40, 512)};
  all.push_back({"camera of 60 degrees", -22 * kDegree, 22 * kDegree, 60, 120, 60 * kDegree});
  all.push_back({"camera of 90 degrees", -30 * kDegree, 30 * kDegree, 80, 160, 90 * kDegree});
  return all;
}

RoomScan scanOf(const Room& room, const Lidar& lidar, const CPose3D& sensor, double noise, Rng& rng,
                double tilt)
{
  RoomScan scan;
  scan.view = {sensor, 0, lidar.fieldOfView / lidar.columns};
  scan.params.structureMinZ = 2.2;
  scan.params.structureMaxZ = 2.6;
  const CPose3D tilted =
      CPose3D(0, 0, 0, 0, tilt, 0) + CPose3D(0, 0, 0, sensor.yaw(), sensor.pitch(), sensor.roll());
  Caster caster(room, sensor, rng);
  for (int ring = 0; ring < lidar.rings; ++ring)
    for (int column = 0; column < lidar.columns; ++column)
    {
      const double elevation =
          lidar.lowest + (lidar.highest - lidar.lowest) * ring / (lidar.rings - 1);
      const double azimuth = lidar.fieldOfView * (column + 0.37) / lidar.columns;
      const TPoint3D d(std::cos(elevation) * std::cos(azimuth),
                       std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      const auto point =
          d * (caster.range(tilted.rotateVector(d)) + (noise > 0 ? noise * error(rng) : 0));
      scan.points.emplace_back(static_cast<float>(point.x), static_cast<float>(point.y),
                               static_cast<float>(point.z));
    }
  return scan;
}

}  // namespace mrpt_mapconv::test
