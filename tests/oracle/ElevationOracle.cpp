#include "ElevationOracle.h"

#include <mrpt/poses/CPose3D.h>
#include <mrpt_mapconv/terrain/PlaneFit.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::oracle
{
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;

namespace
{
/** Height of a point of the sensor's frame if the robot is tilted further. */
double heightFor(const terrain::TerrainScan& scan, const TPoint3D& p, double roll, double pitch)
{
  const CPose3D& robot = scan.robotPose;
  const CPose3D tilted(robot.x(), robot.y(), robot.z(), robot.yaw(), robot.pitch() + pitch,
                       robot.roll() + roll);
  return (tilted + (scan.sensorPose - robot)).composePoint(p).z;
}

/** J_S Σ_S J_Sᵀ */
double varianceOfSensor(const terrain::TerrainScan& scan, const terrain::PointSigmas& sigmas,
                        const TPoint3D& p)
{
  const auto rotation = scan.sensorPose.getRotationMatrix();
  const double range = p.norm();
  const double direction[] = {p.x / range, p.y / range, p.z / range};
  double variance = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const double along = direction[i] * direction[j];
      const double across = (i == j ? 1.0 : 0.0) - along;
      variance += rotation(2, i) * rotation(2, j) *
                  (sigmas.range * sigmas.range * along +
                   sigmas.beam * sigmas.beam * range * range * across);
    }
  return variance;
}

/** J_P Σ_P J_Pᵀ, with numeric derivatives. */
double varianceOfPose(const terrain::TerrainScan& scan, const TPoint3D& p)
{
  constexpr double h = 1e-6;
  const double jacobian[] = {1, (heightFor(scan, p, h, 0) - heightFor(scan, p, -h, 0)) / (2 * h),
                             (heightFor(scan, p, 0, h) - heightFor(scan, p, 0, -h)) / (2 * h)};
  double variance = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) variance += jacobian[i] * scan.poseCovariance(i, j) * jacobian[j];
  return variance;
}

/** Mass of a normal distribution, whose σ is half a cell, in the cell at an offset. */
double massIn(int offset)
{
  const auto upTo = [](double cells) { return 0.5 * std::erfc(-cells / 0.5 / std::sqrt(2)); };
  return upTo(offset + 0.5) - upTo(offset - 0.5);
}
}  // namespace

void SlowElevationMap::insert(const terrain::TerrainScan& scan, const terrain::PointSigmas& sigmas)
{
  for (auto& [key, cell] : cells) cell.fusedByThisScan = false;
  for (std::size_t i = 0; i < scan.points; ++i)
  {
    const TPoint3D p(scan.x[i], scan.y[i], scan.z[i]);
    const TPoint3D m = scan.sensorPose.composePoint(p);
    const double z = std::floor(m.z / terrain::kHeightUnit + 0.5) * terrain::kHeightUnit;
    update(keyOf(m.x), keyOf(m.y), z, varianceOfSensor(scan, sigmas, p) + varianceOfPose(scan, p));
  }
  for (auto it = cells.begin(); it != cells.end();)
  {
    it->second.variance = std::max(it->second.variance, m_params.minVariance);
    it = it->second.variance > m_params.maxVariance ? cells.erase(it) : std::next(it);
  }
}

int SlowElevationMap::keyOf(double metres) const
{
  return static_cast<int>(std::floor(metres / m_resolution + 0.5));
}

void SlowElevationMap::update(int kx, int ky, double z, double variance)
{
  const auto found = cells.find({kx, ky});
  if (found == cells.end())
  {
    cells[{kx, ky}] = {z, variance, false};
    return;
  }
  Cell& cell = found->second;
  const double distance = std::abs(z - cell.height) / std::sqrt(cell.variance);
  if (distance <= m_params.mahalanobisDistanceThreshold)
  {
    cell.height = (cell.variance * z + variance * cell.height) / (cell.variance + variance);
    cell.variance = variance * cell.variance / (variance + cell.variance);
    cell.fusedByThisScan = true;
  }
  else if (!cell.fusedByThisScan)
    cell.variance += m_params.multiHeightNoise;
  else if (z > cell.height)
    cell = {z, variance, true};
}

SlowFusion::SlowFusion(const grid::Layer<float>& heights, const grid::Layer<float>& variances,
                       std::int32_t ix, std::int32_t iy)
{
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
    {
      const std::int32_t x = ix + dx, y = iy + dy;
      if (x < 0 || y < 0 || x >= heights.frame().width || y >= heights.frame().height) continue;
      if (std::isnan(heights.at(x, y))) continue;
      const double weight = massIn(dx) * massIn(dy), h = static_cast<double>(heights.at(x, y));
      const double reach = 2 * std::sqrt(static_cast<double>(variances.at(x, y)));
      m_weights += weight;
      m_sum += weight * h;
      m_lower.emplace_back(h - reach, weight);
      m_upper.emplace_back(h + reach, weight);
    }
}

/** Linear between the values; the lowest has probability 0, the highest 1. */
double SlowFusion::quantile(Weighted values, double probability) const
{
  std::sort(values.begin(), values.end());
  double before = 0;
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    const double here = before + values[i].second / (m_weights - values[0].second);
    if (here >= probability)
      return values[i - 1].first +
             (values[i].first - values[i - 1].first) * (probability - before) / (here - before);
    before = here;
  }
  return values.back().first;
}

}  // namespace mrpt_mapconv::oracle
