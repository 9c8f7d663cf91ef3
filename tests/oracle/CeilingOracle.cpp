#include "CeilingOracle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace mrpt_mapconv::oracle
{
namespace
{
constexpr int kSectors = 256;

struct Direction
{
  double x, y;
};

/** Where sector i begins, on |x| + |y| = 1. */
Direction beginOf(int i)
{
  const double t = 4.0 * (i % kSectors) / kSectors;
  if (t < 1) return {1 - t, t};
  if (t < 2) return {1 - t, 2 - t};
  if (t < 3) return {t - 3, 2 - t};
  return {t - 3, t - 4};
}

bool isInSector(int i, double x, double y)
{
  const Direction from = beginOf(i), to = beginOf(i + 1);
  return from.x * y - from.y * x >= 0 && x * to.y - y * to.x > 0;
}

struct Place
{
  double x, y, height;  // from the sensor; above the base

  double range() const { return std::hypot(x, y); }
};

/** The points of a slice, from the sensor. */
std::vector<Place> pointsBetween(double low, double high,
                                 const std::vector<mrpt::math::TPoint3Df>& points,
                                 const scan::Viewpoint& view)
{
  std::vector<Place> places;
  for (const auto& point : points)
  {
    const auto inMap = view.sensorPose.composePoint(mrpt::math::TPoint3D(point));
    const double height = inMap.z - view.baseZ;
    if (height >= low && height <= high)
      places.push_back({inMap.x - view.sensorPose.x(), inMap.y - view.sensorPose.y(), height});
  }
  return places;
}

/** The middles of the cells that hold any, from the sensor. */
std::vector<Place> cellsOf(const std::vector<Place>& places, const scan::Viewpoint& view,
                           double resolution)
{
  std::set<std::pair<double, double>> middles;
  const auto middle = [&](double offset, double sensor)
  { return (std::floor((sensor + offset) / resolution) + 0.5) * resolution - sensor; };
  for (const Place& p : places)
    middles.emplace(middle(p.x, view.sensorPose.x()), middle(p.y, view.sensorPose.y()));
  std::vector<Place> cells;
  for (const auto& [x, y] : middles) cells.push_back({x, y, 0});
  return cells;
}

std::vector<Place> ofSector(int i, const std::vector<Place>& places)
{
  std::vector<Place> inside;
  for (const Place& p : places)
    if (isInSector(i, p.x, p.y)) inside.push_back(p);
  return inside;
}

bool isNearer(const Place& a, const Place& b) { return a.range() < b.range(); }

/** Height at the sensor, slopes along x and y. */
using Plane = Eigen::Vector3d;

double above(const Plane& plane, const Place& p)
{
  return p.height - plane.dot(Eigen::Vector3d(1, p.x, p.y));
}

double weightOf(const Place& p) { return 1 / (1 + p.range() * p.range()); }

/** Least Σ w·(error² + (0.5 m · slope)²), then with the slope cut to 0.1. */
Plane planeThrough(const std::vector<Place>& points)
{
  Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double weights = 0;
  for (const Place& p : points)
  {
    const Eigen::Vector3d row(1, p.x, p.y);
    left += weightOf(p) *
            (row * row.transpose() + 0.25 * Eigen::Vector3d(0, 1, 1).asDiagonal().toDenseMatrix());
    right += weightOf(p) * p.height * row;
    weights += weightOf(p);
  }
  Plane plane = left.ldlt().solve(right);
  const double slope = std::hypot(plane.y(), plane.z());
  if (slope <= 0.1) return plane;
  plane = Plane(0, plane.y() * 0.1 / slope, plane.z() * 0.1 / slope);
  double errors = 0;
  for (const Place& p : points) errors += weightOf(p) * above(plane, p);
  plane.x() = errors / weights;
  return plane;
}

Plane planeUnderTheTop(const std::vector<Place>& points, double band)
{
  Plane plane = planeThrough(points);
  for (int again = 0; again < 5; ++again)
  {
    std::vector<Place> left;
    for (const Place& p : points)
      if (above(plane, p) >= -band) left.push_back(p);
    plane = planeThrough(left);
  }
  return plane;
}

/** Whether a sector's points near the plane have ranges that differ by more than 0.5 m. */
bool goesOn(const std::vector<Place>& points, const Plane& plane, double band)
{
  double least = 1e9, most = 0;
  for (const Place& p : points)
  {
    if (std::abs(above(plane, p)) > band) continue;
    least = std::min(least, p.range());
    most = std::max(most, p.range());
  }
  return most - least > 0.5;
}

bool isHarmful(const std::vector<Place>& cells, const std::vector<Place>& nearest)
{
  std::size_t cut = 0;
  for (const Place& wall : nearest)
    for (int i = 0; i < kSectors; ++i)
      if (isInSector(i, wall.x, wall.y))
        for (const Place& cell : ofSector(i, cells))
          if (cell.range() > wall.range() + 0.3) ++cut;
  return !cells.empty() && 10 * cut >= cells.size();
}
}  // namespace

std::optional<double> ceilingOf(const std::vector<mrpt::math::TPoint3Df>& points,
                                const scan::Viewpoint& view, double resolution,
                                const scan::ProfileParams& params)
{
  const auto structure = pointsBetween(params.structureMinZ, params.structureMaxZ, points, view);
  std::vector<Place> objects, nearest;
  for (const Place& p : pointsBetween(params.objectMinZ, params.objectMaxZ, points, view))
    if (p.range() >= params.minRange && p.range() <= params.maxRange) objects.push_back(p);
  for (int i = 0; i < kSectors; ++i)
    if (const auto walls = ofSector(i, structure); !walls.empty())
      nearest.push_back(*std::min_element(walls.begin(), walls.end(), isNearer));
  if (nearest.size() < 16) return std::nullopt;

  const double band = std::min(0.05, (params.structureMaxZ - params.structureMinZ) / 6);
  const Plane plane = planeUnderTheTop(nearest, band);
  double level = 0, goingOn = 0, near = 0, higher = 0, heights = 0;
  for (const Place& p : nearest)
  {
    if (std::abs(above(plane, p)) > band) continue;
    ++level;
    heights += p.height - above(plane, p);
    for (int i = 0; i < kSectors; ++i)
      if (isInSector(i, p.x, p.y) && goesOn(ofSector(i, structure), plane, band)) ++goingOn;
  }
  for (const Place& p : structure)
  {
    if (above(plane, p) > band)
      ++higher;
    else if (above(plane, p) >= -band)
      ++near;
  }
  const double height = heights / level, all = static_cast<double>(nearest.size());
  const bool isPlane = 5 * level >= 3 * all && goingOn > level / 2 && higher < near / 4;
  const bool isTop = height < params.structureMaxZ - 2 * band && higher <= near / 100;
  if (3 * level < all || !(isPlane || isTop)) return std::nullopt;
  if (!isHarmful(cellsOf(objects, view, resolution), nearest)) return std::nullopt;
  return height;
}

}  // namespace mrpt_mapconv::oracle
