#pragma once

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "support/ScanFixtures.h"

namespace mrpt_mapconv::fixtures
{
/** A room without anything in it, whose floor is at z = 0 [m]. */
struct Room
{
  double xMin = -3, xMax = 3, yMin = -2, yMax = 2, ceiling = 2.5;
};

constexpr double kLidarHeight = 1;  // [m] above the robot's base

/** How far it is to the walls, the floor or the ceiling. */
inline double rangeIn(const Room& room, const mrpt::math::TPoint3D& from,
                      const mrpt::math::TPoint3D& direction)
{
  const auto along = [](double start, double step, double low, double high)
  {
    if (step == 0) return std::numeric_limits<double>::infinity();
    return ((step > 0 ? high : low) - start) / step;
  };
  return std::min({along(from.x, direction.x, room.xMin, room.xMax),
                   along(from.y, direction.y, room.yMin, room.yMax),
                   along(from.z, direction.z, 0, room.ceiling)});
}

/** The warnings of a map, without what MRPT puts around them. */
class WarningsOf
{
 public:
  explicit WarningsOf(CScanShapeGridMap2D& map)
  {
    map.log().logRegisterCallback(
        [this](std::string_view text, const mrpt::system::VerbosityLevel level, std::string_view,
               const mrpt::Clock::time_point)
        {
          if (level == mrpt::system::LVL_WARN) texts.emplace_back(text);
        });
  }
  std::vector<std::string> texts;
};

/** What a lidar on a robot that stands upright sees of a room. */
inline mrpt::obs::CObservationPointCloud scanOf(const Room& room, const mrpt::poses::CPose3D& robot)
{
  mrpt::obs::CObservationPointCloud scan;
  scan.sensorLabel = "LIDAR";
  scan.sensorPose = mrpt::poses::CPose3D(0.1, 0, kLidarHeight);
  scan.pointcloud = mrpt::maps::CSimplePointsMap::Create();
  const auto sensor = robot + scan.sensorPose;
  const mrpt::math::TPoint3D from = sensor.translation();
  for (int azimuth = 0; azimuth < 360; ++azimuth)
    for (int elevation = -60; elevation <= 60; elevation += 2)
    {
      const double a = mrpt::DEG2RAD(azimuth + 0.5),
                   e = mrpt::DEG2RAD(static_cast<double>(elevation));
      const mrpt::math::TPoint3D ray(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a),
                                     std::sin(e));
      const double range = rangeIn(room, from, sensor.rotateVector(ray));
      scan.pointcloud->insertPoint(mrpt::math::TPoint3Df(ray * range));
    }
  return scan;
}

/** What a 2D scanner 0.4 m above the base of that robot sees. */
inline mrpt::obs::CObservation2DRangeScan scan2DOf(const Room& room,
                                                   const mrpt::poses::CPose3D& robot)
{
  mrpt::obs::CObservation2DRangeScan scan;
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 0.4);
  scan.aperture = static_cast<float>(1.5 * M_PI);
  scan.maxRange = 30;
  constexpr std::size_t rays = 271;
  scan.resizeScan(rays);
  const auto sensor = robot + scan.sensorPose;
  for (std::size_t i = 0; i < rays; ++i)
  {
    const double angle = scan.aperture * (static_cast<double>(i) / (rays - 1) - 0.5);
    const mrpt::math::TPoint3D ray(std::cos(angle), std::sin(angle), 0);
    scan.setScanRange(
        i, static_cast<float>(rangeIn(room, sensor.translation(), sensor.rotateVector(ray))));
    scan.setScanRangeValidity(i, true);
  }
  return scan;
}

/** A map whose slices fit the room. */
inline CScanShapeGridMap2D mapForRooms(double resolution = 0.1)
{
  CScanShapeGridMap2D map(resolution);
  map.log().logging_enable_console_output = false;
  map.scanInsertionOptions.profile.structureMinZ = 2;
  map.scanInsertionOptions.profile.structureMaxZ = 2.4;
  return map;
}

inline CScanShapeGridMap2D mapOf(const Room& room, double resolution = 0.1)
{
  auto map = mapForRooms(resolution);
  const mrpt::poses::CPose3D robot(0.3, -0.2, 0, 0.4, 0, 0);
  EXPECT_TRUE(map.insertObservation(scanOf(room, robot), robot));
  return map;
}

/** The raw cell with a key; unknown outside of the grid. */
inline int cellAt(const CScanShapeGridMap2D& map, std::int32_t kx, std::int32_t ky)
{
  const grid::GridFrame frame = map.frame();
  return frame.containsKey(kx, ky) ? map.getRawMap()[frame.indexOfKey(kx, ky)] : 0;
}

/** Expects two maps to say the same everywhere, wherever their grids end. */
inline void expectSameCells(const CScanShapeGridMap2D& a, const CScanShapeGridMap2D& b)
{
  const grid::GridFrame both = unite(a.frame(), b.frame());
  std::size_t different = 0;
  for (std::int32_t ky = both.y0; ky < both.yEnd(); ++ky)
    for (std::int32_t kx = both.x0; kx < both.xEnd(); ++kx)
      different += cellAt(a, kx, ky) != cellAt(b, kx, ky) ? 1 : 0;
  EXPECT_EQ(different, 0u);
}

/** How many raw cells are as asked for. */
inline std::size_t countCells(const CScanShapeGridMap2D& map, const std::function<bool(int)>& is)
{
  return static_cast<std::size_t>(
      std::count_if(map.getRawMap().begin(), map.getRawMap().end(), is));
}

}  // namespace mrpt_mapconv::fixtures
