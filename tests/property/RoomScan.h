#pragma once

#include <mrpt_mapconv/scan/ScanProfile.h>

#include <string>
#include <vector>

#include "RandomMap.h"

namespace mrpt_mapconv::test
{
/** A rectangular room with the robot's base near the origin, in a larger hall with walls
 * hallMargin beyond its own if some are of glass. */
struct Room
{
  double xMin = -4, xMax = 5, yMin = -3, yMax = 4, ceiling = 2.5;
  unsigned glass = 0;     //!< walls of glass: 1 right, 2 left, 4 back, 8 front
  double lintel = 2.1;    //!< glass ends below it [m]; one beam in ten is seen on the pane
  double hallMargin = 6;  //!< [m]
};

/** A lidar with rings of beams, or a camera if it does not look all around. */
struct Lidar
{
  std::string name = "32 rings";
  double lowest = -0.6, highest = 0.8;  //!< elevations [rad]
  int rings = 32, columns = 360;
  double fieldOfView = 6.283185307179586;  //!< [rad]
};

/** Sparse and dense ones, and cameras. */
std::vector<Lidar> commonLidars();

struct RoomScan
{
  std::vector<mrpt::math::TPoint3Df> points;
  scan::Viewpoint view;
  scan::ProfileParams params;  //!< structure slice 2.2 to 2.6 m
};

/** What a lidar sees in a room.
 * \param sensor where it is, as the scan says
 * \param tilt how it is turned besides, unknown to the scan: pitch [rad]
 * \param noise of the ranges, standard deviation [m] */
RoomScan scanOf(const Room& room, const Lidar& lidar, const mrpt::poses::CPose3D& sensor,
                double noise, Rng& rng, double tilt = 0);

}  // namespace mrpt_mapconv::test
