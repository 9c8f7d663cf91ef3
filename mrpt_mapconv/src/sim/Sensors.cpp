#include <mrpt_mapconv/sim/Sensors.h>

#include <utility>
#include <vector>

#include "Echo.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;

namespace
{
/** \param key of what is random on the first ray's way; those of others count on from it */
std::vector<Ray> raysFrom(const CPose3D& sensor, const std::vector<TPoint3Df>& directions,
                          std::uint64_t key)
{
  const auto& rotation = sensor.getRotationMatrix();
  const TPoint3Df origin(static_cast<float>(sensor.x()), static_cast<float>(sensor.y()),
                         static_cast<float>(sensor.z()));
  std::vector<Ray> rays;
  rays.reserve(directions.size());
  for (const TPoint3Df& d : directions)
  {
    const auto row = [&](int i) {
      return static_cast<float>(rotation(i, 0) * d.x + rotation(i, 1) * d.y + rotation(i, 2) * d.z);
    };
    rays.push_back({origin, TPoint3Df(row(0), row(1), row(2)), key + rays.size()});
  }
  return rays;
}
}  // namespace

Sensor::Sensor(SensorParams params, std::vector<TPoint3Df> directions)
    : m_params(std::move(params)), m_directions(std::move(directions))
{
}

Scan Sensor::scan(const RayCaster& caster, const CPose3D& robotPose, std::uint64_t key) const
{
  const std::uint64_t wayKey = mixBits(key), noiseKey = mixBits(~key);
  const auto rays = raysFrom(robotPose + m_params.pose, m_directions, wayKey);
  const auto maxRange = static_cast<float>(m_params.maxRange);

  Scan out;
  out.is3D = is3D();
  std::vector<float> ranges(rays.size(), 0.0f);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    // From the sensor on, not from minRange: what is too near to be measured hides what is behind.
    const Echo echo = echoOf(caster, rays[i], maxRange, Random(rays[i].key));
    if (echo.body < 0 || static_cast<double>(echo.range) < m_params.minRange) continue;
    Random random(noiseKey + i);
    if (random.uniform() < m_params.dropout) continue;
    const double range = echo.range + m_params.rangeNoise * random.normal();
    if (range < m_params.minRange || range > m_params.maxRange || range <= 0) continue;
    ranges[i] = static_cast<float>(range);
    out.truePoints.push_back(echo.place);
    out.bodies.push_back(echo.body);
    out.mirrored.push_back(echo.mirrored ? 1 : 0);
  }
  out.observation = observation(ranges);
  out.observation->timestamp = INVALID_TIMESTAMP;  // MRPT takes the clock's
  out.observation->sensorLabel = m_params.name;
  out.observation->setSensorPose(m_params.pose);
  return out;
}

}  // namespace mrpt_mapconv::sim
