#include <mrpt_mapconv/sim/Sensors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "Random.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;

namespace
{
constexpr std::size_t kMostPanes = 8;
constexpr float kBehindPane = 1e-4f;  //!< so that a ray does not meet the same surface again [m]

/** Where a ray that met a surface goes on [m]: farther, also where single precision is coarse. */
float behind(float range)
{
  return std::max(range + kBehindPane,
                  std::nextafter(range, std::numeric_limits<float>::infinity()));
}

TPoint3Df along(const Ray& ray, float range)
{
  return {ray.origin.x + range * ray.direction.x, ray.origin.y + range * ray.direction.y,
          ray.origin.z + range * ray.direction.z};
}

std::vector<Ray> raysFrom(const CPose3D& sensor, const std::vector<TPoint3Df>& directions)
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
    rays.push_back({origin, TPoint3Df(row(0), row(1), row(2))});
  }
  return rays;
}
}  // namespace

Sensor::Sensor(SensorParams params, std::vector<TPoint3Df> directions)
    : m_params(std::move(params)), m_directions(std::move(directions))
{
}

/** What the rays show: the first surface that is not looked through. They begin at the sensor, not
 * at minRange: what is too near to be measured still hides what is behind it. */
std::vector<Hit> Sensor::visibleHits(const RayCaster& caster, const std::vector<Ray>& rays,
                                     std::uint64_t key) const
{
  const auto maxRange = static_cast<float>(m_params.maxRange);
  std::vector<Hit> hits;
  caster.cast(rays, 0, maxRange, hits);
  std::vector<std::int32_t> passed;
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    Random random(mixBits(key) + i);
    passed.clear();
    while (hits[i].primitive >= 0)
    {
      const std::int32_t body = hits[i].primitive;
      if (std::find(passed.begin(), passed.end(), body) == passed.end())
      {
        const double transparency =
            caster.world().primitive(static_cast<std::size_t>(body)).transparency();
        if (transparency <= 0 || passed.size() == kMostPanes) break;
        if (random.uniform() >= transparency) break;
        passed.push_back(body);
      }
      hits[i] = caster.cast(rays[i], behind(hits[i].range), maxRange);
    }
  }
  return hits;
}

Scan Sensor::scan(const RayCaster& caster, const CPose3D& robotPose, std::uint64_t key) const
{
  const auto rays = raysFrom(robotPose + m_params.pose, m_directions);
  const auto hits = visibleHits(caster, rays, key);

  Scan out;
  out.is3D = is3D();
  std::vector<float> ranges(rays.size(), 0.0f);
  const std::uint64_t noiseKey = mixBits(~key);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    if (hits[i].primitive < 0 || static_cast<double>(hits[i].range) < m_params.minRange) continue;
    Random random(noiseKey + i);
    if (random.uniform() < m_params.dropout) continue;
    const double range = hits[i].range + m_params.rangeNoise * random.normal();
    if (range < m_params.minRange || range > m_params.maxRange || range <= 0) continue;
    ranges[i] = static_cast<float>(range);
    out.truePoints.push_back(along(rays[i], hits[i].range));
  }
  out.observation = observation(ranges);
  out.observation->timestamp = INVALID_TIMESTAMP;  // MRPT takes the clock's
  out.observation->sensorLabel = m_params.name;
  out.observation->setSensorPose(m_params.pose);
  return out;
}

}  // namespace mrpt_mapconv::sim
