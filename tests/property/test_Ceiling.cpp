// A ceiling in the structure slice is told from walls: made rooms, and the definition's slow twin.
#include <gtest/gtest.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <cmath>
#include <string>

#include "../oracle/CeilingOracle.h"
#include "RoomScan.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using mrpt::poses::CPose3D;

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;
constexpr double kResolution = 0.05;
const CPose3D kSensor(0, 0, 1, 0, 0, 0);

std::optional<double> ceilingOf(const RoomScan& scan)
{
  scan::ScanProfile profile;
  profile.compute(scan.points, scan.view, kResolution, scan.params);
  return profile.statistics().ceiling;
}

/** What is found in a room from the usual place, with a noise of 2 cm. */
std::optional<double> ceilingIn(const Room& room, const Lidar& lidar = {}, double tilt = 0)
{
  Rng rng(1);
  return ceilingOf(scanOf(room, lidar, kSensor, 0.02, rng, tilt));
}

Room roomOf(double length, double width, double ceiling)
{
  return {-length / 2, length / 2, -width / 2, width / 2, ceiling};
}

Room glassRoomOf(double length, double width, double ceiling, unsigned glass = 15)
{
  Room room = roomOf(length, width, ceiling);
  room.glass = glass;
  return room;
}

TEST(Ceiling, IsFoundWhereTheSliceHoldsIt)
{
  for (const double height : {2.3, 2.45, 2.55})
  {
    Room room;
    room.ceiling = height;
    const auto ceiling = ceilingIn(room);
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
    EXPECT_FALSE(ceilingIn(room)) << height;
  }
}

TEST(Ceiling, IsNoneWithoutTheFilter)
{
  Rng rng(1);
  RoomScan scan = scanOf({}, {}, kSensor, 0, rng);
  EXPECT_TRUE(ceilingOf(scan));
  scan.params.reflectionFilter = false;
  EXPECT_FALSE(ceilingOf(scan));
}

TEST(Ceiling, IsNoneWhereItHidesNothing)
{
  // The lidar sees the ceiling only behind the walls' feet: in a narrow room, hardly above itself.
  Lidar flat;
  flat.highest = 0.3;
  EXPECT_FALSE(ceilingIn(roomOf(3, 3, 2.5), flat));
}

TEST(Ceiling, IsFoundInCorridorsRoomsAndHalls)
{
  for (const Lidar& lidar : commonLidars())
    for (const Room& room : {roomOf(30, 2.4, 2.45), roomOf(14, 10, 2.45), roomOf(40, 40, 2.45)})
    {
      SCOPED_TRACE(lidar.name + ", " + std::to_string(room.yMax));
      const bool looksAlong = lidar.fieldOfView > 6 || room.yMax > 2;
      EXPECT_TRUE(ceilingIn(room, lidar) || !looksAlong);
    }
}

TEST(Ceiling, IsFoundBySparseLidarsThatSeeItInTheCornersOnly)
{
  const Lidar sparse = commonLidars()[0];
  for (const double shift : {-0.7, -0.4, -0.1, 0.2, 0.5})
  {
    Room room = roomOf(10, 8, 2.45);
    room.xMin += shift;
    room.xMax += shift;
    EXPECT_TRUE(ceilingIn(room, sparse)) << shift;
  }
}

TEST(Ceiling, IsFoundFromATiltedBase)
{
  const auto lidars = commonLidars();
  for (const double degrees : {1.0, 2.0, 3.0})
    for (const std::size_t i : {2U, 3U, 4U})
      EXPECT_TRUE(ceilingIn(roomOf(30, 30, 2.45), lidars[i], degrees * kDegree))
          << lidars[i].name << ", " << degrees << " degrees";
  EXPECT_TRUE(ceilingIn(roomOf(30, 30, 2.45), lidars[0], 2 * kDegree));
}

TEST(Ceiling, IsNoGlassFrontWithWallAboveIt)
{
  for (const Lidar& lidar : commonLidars())
    for (const double degrees : {0.0, 1.0})
      for (const Room& room : {glassRoomOf(10, 8, 3), glassRoomOf(9, 9, 3.2),
                               glassRoomOf(16, 12, 3, 1), glassRoomOf(24, 3, 3, 12)})
      {
        SCOPED_TRACE(lidar.name + ", " + std::to_string(degrees) + " degrees");
        EXPECT_FALSE(ceilingIn(room, lidar, degrees * kDegree)) << room.xMax << " x " << room.yMax;
      }
}

TEST(Ceiling, IsNoSingleRingOnAWall)
{
  // all that is in the slice is the highest ring, at nearly one height: 2.21 to 2.32 m
  Room room{-2, 4.5, -2, 2, 3.2, 1};
  EXPECT_FALSE(ceilingIn(room, commonLidars()[0]));
}

/** From anywhere in a room, every other time from a base that is tilted unnoticed. */
RoomScan randomScanOf(const Room& room, const Lidar& lidar, Rng& rng)
{
  const CPose3D sensor(uniform(rng, -0.8, 0.8) * room.xMax, uniform(rng, -0.8, 0.8) * room.yMax,
                       uniform(rng, 0.5, 1.6), uniform(rng, -kPi, kPi), 0, 0);
  const double tilt = chance(rng, 50) ? uniform(rng, 0, 2 * kDegree) : 0;
  return scanOf(room, lidar, sensor, chance(rng, 50) ? 0.01 : 0.03, rng, tilt);
}

/** True if the reflection filter takes more than 15 % of the occupied cells away. */
bool isMuchCut(RoomScan scan)
{
  const auto cells = [&]
  {
    scan::ScanProfile profile;
    profile.compute(scan.points, scan.view, kResolution, scan.params);
    return static_cast<double>(profile.statistics().occupiedCells);
  };
  const double left = cells();
  scan.params.reflectionFilter = false;
  return left < 0.85 * cells();
}

struct Count
{
  int found = 0, all = 0;
};

/** Of random rooms, 30 for each lidar, of whose scans much is cut. */
Count countCeilings(double lowest, double highest, bool glass)
{
  Count count;
  for (const Lidar& lidar : commonLidars())
    for (unsigned seed = 1; seed <= 30; ++seed)
    {
      Rng rng(seed);
      Room room = roomOf(uniform(rng, 4, 30), uniform(rng, 2, 16), uniform(rng, lowest, highest));
      room.glass = glass ? static_cast<unsigned>(pick(rng, 1, 15)) : 0;
      room.lintel = uniform(rng, 1.8, 2.3);
      const RoomScan scan = randomScanOf(room, lidar, rng);
      if (!isMuchCut(scan)) continue;
      ++count.all;
      count.found += ceilingOf(scan).has_value();
    }
  return count;
}

TEST(Ceiling, IsFoundInMostRandomRoomsWhereItCutsMuch)
{
  const Count count = countCeilings(2.3, 2.55, false);
  EXPECT_GT(count.all, 100);
  EXPECT_GT(count.found, 0.85 * count.all) << count.all;
}

TEST(Ceiling, IsHardlyEverTakenForOneInRandomGlassRooms)
{
  const Count count = countCeilings(2.9, 4, true);
  EXPECT_GT(count.all, 75);  // what is seen through the glass is cut on purpose
  EXPECT_LE(count.found, 1);
}

TEST(Ceiling, AgreesWithTheOracleInRandomRooms)
{
  int found = 0, none = 0;
  for (unsigned seed = 1; seed <= 200 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    Room room{uniform(rng, -9, -1), uniform(rng, 1, 9), uniform(rng, -9, -1), uniform(rng, 1, 9),
              uniform(rng, 2.1, 3)};
    if (chance(rng, 30)) room.glass = static_cast<unsigned>(pick(rng, 1, 15));
    Lidar lidar;
    lidar.highest = uniform(rng, 0.1, 1.2);
    lidar.rings = pick(rng, 4, 24);
    lidar.columns = pick(rng, 10, 300);
    lidar.fieldOfView = uniform(rng, 0.3, 2 * kPi);
    const CPose3D sensor(uniform(rng, -0.9, 0.9), uniform(rng, -0.9, 0.9), uniform(rng, 0.3, 1.8),
                         uniform(rng, -3, 3), uniform(rng, -0.03, 0.03), uniform(rng, -0.03, 0.03));
    RoomScan scan = scanOf(room, lidar, sensor, uniform(rng, 0, 0.03), rng, uniform(rng, 0, 0.2));
    if (chance(rng, 30)) scan.params.structureMinZ = uniform(rng, 2, 2.5);
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
