#include <mrpt/core/Clock.h>
#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/sim/Simulator.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "Random.h"

namespace mrpt_mapconv::sim
{
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

namespace
{
constexpr double kTicksPerSecond = 1e7;
constexpr double kStart = 1735689600.0;  //!< 2025-01-01 00:00 UTC [s]
}  // namespace

Schedule::Schedule(const Scenario& scenario)
    : m_scenario(scenario),
      m_made(scenario.sensors.size(), 0),
      m_end(std::llround(scenario.trajectory.duration() * kTicksPerSecond)),
      m_any3D(std::any_of(scenario.sensors.begin(), scenario.sensors.end(),
                          [](const auto& sensor) { return sensor->is3D(); }))
{
}

std::int64_t Schedule::dueTicks(std::size_t sensor) const
{
  const double rate = m_scenario.sensors[sensor]->params().rate;
  return std::llround(static_cast<double>(m_made[sensor]) * kTicksPerSecond / rate);
}

std::optional<Schedule::Slot> Schedule::next()
{
  Slot slot;
  slot.ticks = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < m_made.size(); ++i) slot.ticks = std::min(slot.ticks, dueTicks(i));
  if (slot.ticks > m_end) return std::nullopt;

  bool candidate = false;
  for (std::size_t i = 0; i < m_made.size(); ++i)
  {
    if (dueTicks(i) != slot.ticks) continue;
    slot.sensors.push_back(i);
    slot.scanIndex.push_back(m_made[i]++);
    candidate |= m_scenario.sensors[i]->is3D() || !m_any3D;
  }
  const auto every = static_cast<std::uint64_t>(m_scenario.log.keyFrameEvery);
  slot.keyFrame = candidate && m_candidates++ % every == 0;
  return slot;
}

Simulator::Simulator(const Scenario& scenario, std::uint64_t seed)
    : m_scenario(scenario), m_seed(seed), m_caster(scenario.world), m_schedule(scenario)
{
}

OdometrySpread odometrySpread(const CPose2D& step, const NoiseParams& noise)
{
  const double way = std::sqrt(step.norm());
  const double turn = std::sqrt(std::abs(step.phi()) / mrpt::DEG2RAD(360.0));
  return {noise.odometryPerMetre * way, mrpt::DEG2RAD(std::hypot(noise.odometryYawPerMetre * way,
                                                                 noise.odometryYawPerTurn * turn))};
}

/** Adds what the robot's encoders say about its way since the last moment. */
void Simulator::moveOdometry(const CPose2D& truth)
{
  const CPose2D step = truth - m_truth;
  const auto spread = odometrySpread(step, m_scenario.noise);
  const double drift = mrpt::DEG2RAD(m_scenario.noise.odometryDrift * step.norm());
  Random random(randomKey(m_seed, "odometry", m_moments));
  const double x = step.x() + spread.position * random.normal();
  const double y = step.y() + spread.position * random.normal();
  const double yaw = step.phi() + drift + spread.yaw * random.normal();
  m_odometry = m_odometry + CPose2D(x, y, yaw);
  m_truth = truth;
}

CPose3D Simulator::estimateOf(const CPose3D& pose) const
{
  const NoiseParams& noise = m_scenario.noise;
  Random random(randomKey(m_seed, "pose", m_moments));
  const auto shift = [&](double metres) { return metres * random.normal(); };
  const auto turn = [&](double degrees) { return mrpt::DEG2RAD(degrees * random.normal()); };
  const double x = pose.x() + shift(noise.posePosition);
  const double y = pose.y() + shift(noise.posePosition);
  double z = pose.z() + shift(noise.posePosition);
  const double yaw = pose.yaw() + turn(noise.poseAngle);
  double pitch = pose.pitch() + turn(noise.poseAngle);
  double roll = pose.roll() + turn(noise.poseAngle);
  // last, so that what else is random is the same with and without
  z += shift(noise.poseHeight);
  pitch += turn(noise.poseTilt);
  roll += turn(noise.poseTilt);
  return {x, y, z, yaw, pitch, roll};
}

std::optional<Moment> Simulator::next()
{
  const auto slot = m_schedule.next();
  if (!slot) return std::nullopt;

  Moment moment;
  moment.seconds = static_cast<double>(slot->ticks) / kTicksPerSecond;
  moment.time = mrpt::Clock::fromDouble(kStart) + mrpt::Clock::duration(slot->ticks);
  moment.pose = m_scenario.trajectory.poseAt(moment.seconds);
  moment.estimatedPose = estimateOf(moment.pose);
  moment.keyFrame = slot->keyFrame;
  if (m_moments == 0)
    m_odometry = m_truth = CPose2D(moment.pose);
  else
    moveOdometry(CPose2D(moment.pose));
  moment.odometry = m_odometry;

  m_caster.moveTo(moment.seconds);
  for (std::size_t i = 0; i < slot->sensors.size(); ++i)
  {
    const Sensor& sensor = *m_scenario.sensors[slot->sensors[i]];
    const auto key = randomKey(m_seed, "sensor." + sensor.params().name, slot->scanIndex[i]);
    moment.scans.push_back(sensor.scan(m_caster, moment.pose, key));
    moment.scans.back().observation->timestamp = moment.time;
  }
  ++m_moments;
  return moment;
}

}  // namespace mrpt_mapconv::sim
