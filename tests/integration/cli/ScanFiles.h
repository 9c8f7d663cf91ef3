#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CSerializable.h>

#include <limits>
#include <string>
#include <vector>

namespace mrpt_mapconv::testing
{
/** Entries of a rawlog, or whatever else an MRPT file holds. */
using Objects = std::vector<mrpt::serialization::CSerializable::Ptr>;

/** A point straight below the sensor of a robot, on the ground: with voxels of 0.1 m the column
 * under the sensor is occupied at key 0 and free at keys 1 … 20, so its floor is 0.1 m and its
 * ceiling 2.1 m. The sensor is at (0.05, 0.05, 2.05) m on the robot. \param seconds its time */
mrpt::obs::CObservation::Ptr lookDown(double seconds);
/** The same, but its only point has this x. */
mrpt::obs::CObservation::Ptr badPoint(float x, double seconds);
/** A scan of these points [m], given on the robot, seen from a sensor at `sensor`. */
mrpt::obs::CObservation::Ptr cloudOn(const std::vector<mrpt::math::TPoint3Df>& points,
                                     const mrpt::math::TPoint3D& sensor, double seconds);
/** A level 2D scan, 1 m ahead and beside the robot. */
mrpt::obs::CObservation::Ptr scan2D(double seconds);
/** The robot's pose at a time. */
mrpt::obs::CObservation::Ptr robotAt(double x, double seconds);
mrpt::obs::CObservation::Ptr odometryAt(double x, double seconds);

void writeObjects(const std::string& path, const Objects& objects, bool gzipped = false);
/** A simplemap of these scans, all taken at the origin. */
void writeSimpleMap(const std::string& path,
                    const std::vector<mrpt::obs::CObservation::Ptr>& scans);
/** A simplemap with a keyframe of one lookDown() at each x. */
void writeSimpleMap(const std::string& path, const std::vector<double>& xs, bool gzipped);

}  // namespace mrpt_mapconv::testing
