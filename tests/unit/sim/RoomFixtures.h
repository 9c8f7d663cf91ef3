#pragma once

#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "support/TempDir.h"

/** An empty room whose walls, floor and roof are known in closed form. */
namespace mrpt_mapconv::sim::fixtures
{
using mrpt_mapconv::testing::TempDir;

/** The room's inside: x −5 … 5, y −4 … 4, z 0 … 3 [m]. */
inline const std::string kRoom = R"(
[world]
bounds = -6 -6 -1  6 6 3.1
[box.floor]
min = -5.5 -4.5 -0.2
max = 5.5 4.5 0
[box.roof]
min = -5.5 -4.5 3
max = 5.5 4.5 3.2
[box.west]
min = -5.5 -4.5 0
max = -5 4.5 3
[box.east]
min = 5 -4.5 0
max = 5.5 4.5 3
[box.south]
min = -5 -4.5 0
max = 5 -4 3
[box.north]
min = -5 4 0
max = 5 4.5 3
)";

inline const std::string kDrive = R"(
[trajectory]
waypoints = [0 0 0] [2 0 0] [2 2 0]
speed = 0.5
turnRate = 45
)";

inline const std::string kLidar = R"(
[sensor.lidar]
kind = lidar
pose = 0.1 -0.2 0.9  10 5 -3
beams = 16
elevationMin = -60
elevationMax = 60
azimuthSteps = 90
rate = 2
maxRange = 20
)";

inline const std::string kCamera = R"(
[sensor.camera]
kind = depthCamera
pose = 0.2 0.1 1.1  -30 10 2
width = 41
height = 30
fieldOfView = 80
rate = 1
maxRange = 6.5
)";

inline const std::string kScanner = R"(
[sensor.front]
kind = scanner2D
pose = 0.1 0 0.4  0 0 0
fieldOfView = 270
rays = 91
rate = 10
maxRange = 20
)";

inline Scenario load(const std::string& text)
{
  const TempDir dir;
  std::ofstream(dir.path("world.ini")) << text;
  return Scenario::load(dir.path("world.ini"));
}

/** How far it is from a point in the room to its wall, floor or roof. \param d of length 1 */
inline double rangeInRoom(const mrpt::math::TPoint3D& p, const mrpt::math::TPoint3D& d)
{
  const double low[] = {-5, -4, 0}, high[] = {5, 4, 3};
  double range = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    if (d[i] != 0) range = std::min(range, ((d[i] > 0 ? high[i] : low[i]) - p[i]) / d[i]);
  return range;
}

/** How far a point is from the room's surface. */
inline double offRoom(const mrpt::math::TPoint3D& p)
{
  const double out = std::max({std::abs(p.x) - 5, std::abs(p.y) - 4, p.z - 3, -p.z});
  return std::abs(out);  // inside, the largest of these is the nearest surface
}

struct Statistics
{
  double mean = 0, sigma = 0;
};
inline Statistics statisticsOf(const std::vector<double>& values)
{
  Statistics s;
  for (const double v : values) s.mean += v / static_cast<double>(values.size());
  for (const double v : values)
    s.sigma += (v - s.mean) * (v - s.mean) / static_cast<double>(values.size() - 1);
  s.sigma = std::sqrt(s.sigma);
  return s;
}

/** Checks a normal sample against what it was drawn with, at four standard errors. */
inline void expectNormal(const std::vector<double>& values, double sigma, const std::string& what)
{
  const auto s = statisticsOf(values);
  const double n = static_cast<double>(values.size());
  EXPECT_NEAR(s.mean, 0, 4 * sigma / std::sqrt(n)) << what;
  EXPECT_NEAR(s.sigma, sigma, 4 * sigma / std::sqrt(2 * n)) << what;
}

}  // namespace mrpt_mapconv::sim::fixtures
