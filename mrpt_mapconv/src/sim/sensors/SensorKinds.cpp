#include "SensorKinds.h"

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv::sim
{
using params::StrictSection;

namespace
{
std::string textOf(double value)
{
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/** Reads a number that need not be there. */
void readOptional(StrictSection& section, const std::string& key, double low, double high,
                  double& value)
{
  if (section.has(key)) value = readWithin(section, key, low, high);
}

mrpt::poses::CPose3D readPose(StrictSection& section)
{
  std::vector<double> v(6, 0.0);
  section.read("pose", v);
  if (v.size() != 6) section.fail("pose", "6 numbers: x y z [m] yaw pitch roll [degrees]");
  return {v[0], v[1], v[2], mrpt::DEG2RAD(v[3]), mrpt::DEG2RAD(v[4]), mrpt::DEG2RAD(v[5])};
}

SensorParams readParams(StrictSection& section)
{
  SensorParams p;
  p.name = section.name().substr(section.name().find('.') + 1);
  if (p.name.empty())
    throw std::runtime_error("section '" + section.name() + "' must have a name: sensor.NAME");
  p.pose = readPose(section);
  p.rate = readWithin(section, "rate", 0.001, 1000);
  p.maxRange = readWithin(section, "maxRange", 0.01, 10000);
  p.minRange = std::min(p.minRange, p.maxRange / 2);
  readOptional(section, "minRange", 0, 10000, p.minRange);
  if (p.minRange >= p.maxRange) section.fail("minRange", "below maxRange");
  readOptional(section, "rangeNoise", 0, p.maxRange, p.rangeNoise);
  section.read("dropout", p.dropout);
  if (!(p.dropout >= 0 && p.dropout < 1)) section.fail("dropout", "a number from 0 to below 1");
  section.read("spare", p.spare);
  return p;
}
}  // namespace

double readWithin(StrictSection& section, const std::string& key, double low, double high)
{
  double value = low - 1;
  section.read(key, value);
  if (value < low || value > high)
    section.fail(key, "a number from " + textOf(low) + " to " + textOf(high));
  return value;
}

int readCount(StrictSection& section, const std::string& key, int low, int high)
{
  std::int32_t value = low - 1;
  section.read(key, value);
  if (value < low || value > high)
    section.fail(key, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return value;
}

mrpt::math::TPoint3Df directionAt(double azimuth, double elevation)
{
  const double a = mrpt::DEG2RAD(azimuth), e = mrpt::DEG2RAD(elevation);
  return {static_cast<float>(std::cos(e) * std::cos(a)),
          static_cast<float>(std::cos(e) * std::sin(a)), static_cast<float>(std::sin(e))};
}

std::vector<std::string> sensorKinds() { return {"lidar", "depthCamera", "scanner2D"}; }

std::unique_ptr<Sensor> readSensor(StrictSection& section)
{
  using Reader = std::unique_ptr<Sensor> (*)(StrictSection&, SensorParams);
  const auto kinds = sensorKinds();
  const Reader readers[] = {readLidar, readDepthCamera, readScanner2D};
  int kind = -1;
  section.readChoice("kind", kinds, kind);
  if (kind < 0) section.fail("kind", "lidar or depthCamera or scanner2D");

  auto sensor = readers[kind](section, readParams(section));
  section.refuseUnknown("a " + kinds[static_cast<std::size_t>(kind)]);
  return sensor;
}

}  // namespace mrpt_mapconv::sim
