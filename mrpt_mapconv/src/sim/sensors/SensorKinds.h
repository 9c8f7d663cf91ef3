#pragma once

#include <mrpt_mapconv/sim/Sensors.h>

namespace mrpt_mapconv::sim
{
/** Each reads the keys of its kind, see readSensor(). */
std::unique_ptr<Sensor> readLidar(params::StrictSection& section, SensorParams params);
std::unique_ptr<Sensor> readDepthCamera(params::StrictSection& section, SensorParams params);
std::unique_ptr<Sensor> readScanner2D(params::StrictSection& section, SensorParams params);

/** Reads a number that must be there and within limits. */
double readWithin(params::StrictSection& section, const std::string& key, double low, double high);
int readCount(params::StrictSection& section, const std::string& key, int low, int high);

/** The unit vector at these angles [degrees]: x ahead, azimuth to the left, elevation up. */
mrpt::math::TPoint3Df directionAt(double azimuth, double elevation);

}  // namespace mrpt_mapconv::sim
