#include "experiment/terrain/TerrainWalk.h"

#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/sim/Simulator.h>

#include <algorithm>
#include <utility>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
sim::NoiseParams scaled(sim::NoiseParams noise, double factor)
{
  noise.posePosition *= factor;
  noise.poseAngle *= factor;
  noise.poseHeight *= factor;
  noise.poseTilt *= factor;
  return noise;
}
}  // namespace

TerrainWalk::TerrainWalk(const std::string& worldFile, const std::vector<double>& poseNoise,
                         std::uint32_t seed, int maxScans, Progress& progress)
    : m_scenario(sim::Scenario::load(worldFile)), m_noise(poseNoise)
{
  for (const double noise : poseNoise)
    m_poses.push_back(simulate(noise, seed, maxScans, m_poses.empty(), progress));
}

TerrainWalk::Poses TerrainWalk::simulate(double poseNoise, std::uint32_t seed, int maxScans,
                                         bool withPoints, Progress& progress)
{
  const sim::NoiseParams noise = m_scenario.noise;
  m_scenario.noise = scaled(noise, poseNoise);
  Poses poses;
  observation::SensorPoints seen;
  sim::Simulator simulator(m_scenario, seed);
  const auto isOver = [&]
  { return maxScans > 0 && poses.robot.size() >= static_cast<std::size_t>(maxScans); };
  while (const auto moment = isOver() ? std::nullopt : simulator.next())
  {
    progress.done(moment->seconds / m_scenario.trajectory.duration());
    for (const sim::Scan& scan : moment->scans)
    {
      if (!scan.is3D) continue;
      observation::sensorPoints(*scan.observation, moment->estimatedPose, seen);
      poses.robot.push_back(moment->estimatedPose);
      poses.sensor.push_back(seen.sensorPose);
      if (withPoints) m_points.push_back(seen.points);
    }
  }
  m_scenario.noise = noise;
  return poses;
}

std::size_t TerrainWalk::points() const
{
  std::size_t sum = 0;
  for (const auto& scan : m_points) sum += scan.size();
  return sum;
}

terrain::PointSigmas TerrainWalk::sigmas(std::size_t noise) const
{
  terrain::PointSigmas sigmas;
  sigmas.range = 0;
  for (const auto& sensor : m_scenario.sensors)
    if (sensor->is3D()) sigmas.range = std::max(sigmas.range, sensor->params().rangeNoise);
  const sim::NoiseParams poses = scaled(m_scenario.noise, m_noise[noise]);
  sigmas.height = poses.poseZ();
  sigmas.roll = sigmas.pitch = poses.posePitchRoll();
  return sigmas;
}

std::vector<terrain::TerrainScan> TerrainWalk::scans(std::size_t noise) const
{
  static_assert(sizeof(mrpt::math::TPoint3Df) == 3 * sizeof(float));
  const Poses& poses = m_poses[noise];
  std::vector<terrain::TerrainScan> scans;
  for (std::size_t i = 0; i < m_points.size(); ++i)
  {
    if (m_points[i].empty()) continue;
    terrain::TerrainScan scan;
    scan.x = &m_points[i].front().x;
    scan.y = &m_points[i].front().y;
    scan.z = &m_points[i].front().z;
    scan.points = m_points[i].size();
    scan.stride = 3;
    scan.sensorPose = poses.sensor[i];
    scan.robotPose = poses.robot[i];
    scan.poseCovariance = sigmas(noise).poseCovariance();
    scans.push_back(scan);
  }
  return scans;
}

}  // namespace mapconv
