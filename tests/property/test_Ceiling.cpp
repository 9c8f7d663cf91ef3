// A ceiling in the structure slice is told from walls: made rooms, and the definition's slow twin.
#include <gtest/gtest.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "../oracle/CeilingOracle.h"
#include "RandomMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using mrpt::poses::CPose3D;

constexpr double kPi = 3.14159265358979323846;
constexpr double kResolution = 0.05;

/** A rectangular room with the base of the robot at the origin. */
struct Room
{
  double xMin = -4, xMax = 5, yMin = -3, yMax = 4, ceiling = 2.5;
};

/** A lidar with rings of beams, or a camera if it does not look all around. */
struct Lidar
{
  double lowest = -0.6, highest = 0.8;  //!< elevations [rad]
  int rings = 32, columns = 360;
  double fieldOfView = 2 * kPi;
};

/** Distance to the first of floor, ceiling and walls. */
double rangeIn(const Room& room, const CPose3D& sensor, double dx, double dy, double dz)
{
  double range = std::numeric_limits<double>::infinity();
  const auto meet = [&range](double from, double d, double low, double high)
  {
    if (d != 0) range = std::min(range, ((d > 0 ? high : low) - from) / d);
  };
  meet(sensor.x(), dx, room.xMin, room.xMax);
  meet(sensor.y(), dy, room.yMin, room.yMax);
  meet(sensor.z(), dz, 0, room.ceiling);
  return range;
}

struct Scan
{
  std::vector<mrpt::math::TPoint3Df> points;
  scan::Viewpoint view;
  scan::ProfileParams params;
};

Scan scanOf(const Room& room, const Lidar& lidar, const CPose3D& sensor, double noise = 0,
            unsigned seed = 1)
{
  Rng rng(seed);
  Scan scan;
  scan.view = {sensor, 0, lidar.fieldOfView / lidar.columns};
  scan.params.structureMinZ = 2.2;
  scan.params.structureMaxZ = 2.6;
  for (int ring = 0; ring < lidar.rings; ++ring)
    for (int column = 0; column < lidar.columns; ++column)
    {
      const double elevation =
          lidar.lowest + (lidar.highest - lidar.lowest) * ring / (lidar.rings - 1);
      const double azimuth = lidar.fieldOfView * (column + 0.37) / lidar.columns;
      const double dx = std::cos(elevation) * std::cos(azimuth),
                   dy = std::cos(elevation) * std::sin(azimuth), dz = std::sin(elevation);
      const auto inMap = sensor.rotateVector({dx, dy, dz});
      const double range =
          rangeIn(room, sensor, inMap.x, inMap.y, inMap.z) + uniform(rng, -noise, noise);
      scan.points.emplace_back(static_cast<float>(range * dx), static_cast<float>(range * dy),
                               static_cast<float>(range * dz));
    }
  return scan;
}

std::optional<double> ceilingOf(const Scan& scan)
{
  scan::ScanProfile profile;
  profile.compute(scan.points, scan.view, kResolution, scan.params);
  return profile.statistics().ceiling;
}

const CPose3D kSensor(0, 0, 1, 0, 0, 0);

TEST(Ceiling, IsFoundWhereTheSliceHoldsIt)
{
  for (const double height : {2.3, 2.45, 2.55})
  {
    Room room;
    room.ceiling = height;
    const auto ceiling = ceilingOf(scanOf(room, {}, kSensor, 0.02));
    ASSERT_TRUE(ceiling) << height;
    EXPECT_NEAR(*ceiling, height, 0.03);
  }
}

TEST(Ceiling, IsNoneWhereTheSliceEndsBelowIt)
{
  Room room;
  for (const double height : {2.65, 3.0, 8.0})
  {
    room.ceiling = height;
    EXPECT_FALSE(ceilingOf(scanOf(room, {}, kSensor, 0.02))) << height;
  }
}

TEST(Ceiling, IsNoneWithoutTheFilter)
{
  Scan scan = scanOf({}, {}, kSensor);
  EXPECT_TRUE(ceilingOf(scan));
  scan.params.reflectionFilter = false;
  EXPECT_FALSE(ceilingOf(scan));
}

TEST(Ceiling, IsNoneWhereItHidesNothing)
{
  // The lidar sees the ceiling only behind the walls' feet: in a narrow room, hardly above itself.
  Lidar flat;
  flat.highest = 0.3;
  EXPECT_FALSE(ceilingOf(scanOf({-1.5, 1.5, -1.5, 1.5, 2.5}, flat, kSensor)));
}

TEST(Ceiling, IsFoundByATiltedLidarAndByACamera)
{
  EXPECT_TRUE(ceilingOf(scanOf({}, {}, CPose3D(0, 0, 1, 0.3, 0.01, -0.01))));
  Lidar camera;
  camera.fieldOfView = kPi / 2;
  camera.rings = 100;
  EXPECT_TRUE(ceilingOf(scanOf({}, camera, kSensor)));
}

TEST(Ceiling, AgreesWithTheOracleInRandomRooms)
{
  int found = 0, none = 0;
  for (unsigned seed = 1; seed <= 150 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Room room{uniform(rng, -9, -1), uniform(rng, 1, 9), uniform(rng, -9, -1),
                    uniform(rng, 1, 9), uniform(rng, 2.1, 3)};
    Lidar lidar;
    lidar.highest = uniform(rng, 0.1, 1.2);
    lidar.rings = pick(rng, 4, 24);
    lidar.columns = pick(rng, 10, 200);
    lidar.fieldOfView = uniform(rng, 0.3, 2 * kPi);
    const Scan scan =
        scanOf(room, lidar,
               CPose3D(uniform(rng, -0.9, 0.9), uniform(rng, -0.9, 0.9), uniform(rng, 0.3, 1.8),
                       uniform(rng, -3, 3), uniform(rng, -0.03, 0.03), uniform(rng, -0.03, 0.03)),
               uniform(rng, 0, 0.05), seed);
    const auto ours = ceilingOf(scan);
    const auto expected = oracle::ceilingOf(scan.points, scan.view, kResolution, scan.params);
    ASSERT_EQ(ours.has_value(), expected.has_value());
    if (ours)
    {
      EXPECT_NEAR(*ours, *expected, 1e-6);
    }
    ++(ours ? found : none);
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(none, 30);
}

}  // namespace
