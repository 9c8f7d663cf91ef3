#include "TerrainCells.h"

#include <mrpt_mapconv/terrain/PlaneFit.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::oracle
{
namespace
{
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;

constexpr double kStep = 1e-5;  // of finite differences

TPoint3D localPoint(const terrain::TerrainScan& scan, std::size_t point)
{
  const std::size_t at = point * scan.stride;
  return {static_cast<double>(scan.x[at]), static_cast<double>(scan.y[at]),
          static_cast<double>(scan.z[at])};
}

/** A robot that is a little off in z, roll and pitch. */
CPose3D moved(const CPose3D& robot, double z, double roll, double pitch)
{
  return {robot.x(),          robot.y(), robot.z() + z, robot.yaw(), robot.pitch() + pitch,
          robot.roll() + roll};
}

TPoint3D unit(const TPoint3D& v) { return v * (1 / v.norm()); }
TPoint3D cross(const TPoint3D& a, const TPoint3D& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double square(double v) { return v * v; }

double varianceOfPose(const terrain::TerrainScan& scan, const TPoint3D& local)
{
  const CPose3D onRobot = scan.sensorPose - scan.robotPose;
  double j[3];
  for (int i = 0; i < 3; ++i)
  {
    const auto z = [&](double step)
    {
      const CPose3D robot =
          moved(scan.robotPose, i == 0 ? step : 0, i == 1 ? step : 0, i == 2 ? step : 0);
      return (robot + onRobot).composePoint(local).z;
    };
    j[i] = (z(kStep) - z(-kStep)) / (2 * kStep);
  }
  double variance = 0;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) variance += j[i] * scan.poseCovariance(i, k) * j[k];
  return variance;
}

/** Along the beam, and turned about two axes across it. */
double varianceOfSensor(const terrain::TerrainScan& scan, const TPoint3D& local,
                        const terrain::PointSigmas& sigmas)
{
  const double range = local.norm();
  if (range == 0) return 0;
  const TPoint3D along = unit(local);
  const TPoint3D side =
      unit(cross(along, std::abs(along.x) < 0.5 ? TPoint3D(1, 0, 0) : TPoint3D(0, 1, 0)));
  const TPoint3D up = cross(along, side);
  const auto z = [&](const TPoint3D& p) { return scan.sensorPose.composePoint(p).z; };
  const double byRange = z(local + along) - z(local);
  const double bySide = z(local + side * range) - z(local), byUp = z(local + up * range) - z(local);
  return square(sigmas.range * byRange) + square(sigmas.beam) * (square(bySide) + square(byUp));
}

/** A height as it is stored [m]. */
double rounded(double z)
{
  return std::floor(z / terrain::kHeightUnit + 0.5) * terrain::kHeightUnit;
}
}  // namespace

double heightVariance(const terrain::TerrainScan& scan, std::size_t point,
                      const terrain::PointSigmas& sigmas)
{
  const TPoint3D local = localPoint(scan, point);
  return varianceOfSensor(scan, local, sigmas) + varianceOfPose(scan, local);
}

void TerrainCells::insert(const terrain::TerrainScan& scan, const terrain::PointSigmas& sigmas)
{
  for (std::size_t i = 0; i < scan.points; ++i)
  {
    const TPoint3D local = localPoint(scan, i);
    if (!std::isfinite(local.x) || !std::isfinite(local.y) || !std::isfinite(local.z)) continue;
    const TPoint3D p = scan.sensorPose.composePoint(local);
    const double z = rounded(p.z), variance = std::max(1e-6, heightVariance(scan, i, sigmas));
    Cell& cell = m_cells[{static_cast<int>(std::floor(p.y / m_resolution + 0.5)),
                          static_cast<int>(std::floor(p.x / m_resolution + 0.5))}];
    if (cell.points == 0 || z > cell.highest ||
        (z == cell.highest && variance < cell.highestVariance))
    {
      cell.highest = z;
      cell.highestVariance = variance;
    }
    cell.lowest = cell.points == 0 ? z : std::min(cell.lowest, z);
    ++cell.points;
    cell.weight += 1 / variance;
    cell.weightedHeight += z / variance;
  }
}

}  // namespace mrpt_mapconv::oracle
