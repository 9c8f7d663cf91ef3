#include <mrpt_mapconv/sim/Sensors.h>

#include <utility>

#include "Random.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;

namespace
{
constexpr int kMostPanes = 8;
constexpr float kBehindPane = 1e-4f;  //!< so that a ray does not meet the same surface again [m]

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

/** What the rays show: the first surface that is not looked through. */
std::vector<Hit> Sensor::visibleHits(const RayCaster& caster, const std::vector<Ray>& rays,
                                     std::uint64_t key) const
{
  const auto minRange = static_cast<float>(m_params.minRange);
  const auto maxRange = static_cast<float>(m_params.maxRange);
  std::vector<Hit> hits;
  caster.cast(rays, minRange, maxRange, hits);
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    Random random(mixBits(key) + i);
    for (int panes = 0; panes < kMostPanes && hits[i].primitive >= 0; ++panes)
    {
      const auto& body = caster.world().primitive(static_cast<std::size_t>(hits[i].primitive));
      const double transparency = body.transparency();
      if (transparency <= 0 || random.uniform() >= transparency) break;
      hits[i] = caster.cast(rays[i], hits[i].range + kBehindPane, maxRange);
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
    if (hits[i].primitive < 0) continue;
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
