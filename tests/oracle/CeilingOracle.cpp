#include "CeilingOracle.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::oracle
{
namespace
{
constexpr int kSectors = 64;

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

/** Moved to the middle of their cells. */
std::vector<Place> inCells(const std::vector<Place>& places, const scan::Viewpoint& view,
                           double resolution)
{
  std::vector<Place> moved;
  const auto middle = [&](double offset, double sensor)
  { return (std::floor((sensor + offset) / resolution) + 0.5) * resolution - sensor; };
  for (const Place& p : places)
    moved.push_back({middle(p.x, view.sensorPose.x()), middle(p.y, view.sensorPose.y()), p.height});
  return moved;
}

std::vector<Place> ofSector(int i, const std::vector<Place>& places)
{
  std::vector<Place> inside;
  for (const Place& p : places)
    if (isInSector(i, p.x, p.y)) inside.push_back(p);
  return inside;
}

bool isNearer(const Place& a, const Place& b) { return a.range() < b.range(); }
}  // namespace

std::optional<double> ceilingOf(const std::vector<mrpt::math::TPoint3Df>& points,
                                const scan::Viewpoint& view, double resolution,
                                const scan::ProfileParams& params)
{
  const auto structure = pointsBetween(params.structureMinZ, params.structureMaxZ, points, view);
  std::vector<Place> objects;
  for (const Place& p : pointsBetween(params.objectMinZ, params.objectMaxZ, points, view))
    if (p.range() >= params.minRange && p.range() <= params.maxRange) objects.push_back(p);
  objects = inCells(objects, view, resolution);

  std::vector<double> heights;
  for (int i = 0; i < kSectors; ++i)
    if (const auto walls = ofSector(i, structure); !walls.empty())
      heights.push_back(std::min_element(walls.begin(), walls.end(), isNearer)->height);
  if (heights.empty()) return std::nullopt;
  std::sort(heights.begin(), heights.end());
  const double median = heights[heights.size() / 2];

  const double band = std::min(0.05, (params.structureMaxZ - params.structureMinZ) / 4);
  int withObject = 0, shut = 0;
  for (int i = 0; i < kSectors; ++i)
  {
    const auto walls = ofSector(i, structure), things = ofSector(i, objects);
    if (things.empty()) continue;
    ++withObject;
    if (walls.empty()) continue;
    const Place wall = *std::min_element(walls.begin(), walls.end(), isNearer);
    const Place last = *std::max_element(things.begin(), things.end(), isNearer);
    if (std::abs(wall.height - median) <= band && last.range() > wall.range() + 0.3) ++shut;
  }
  if (withObject >= 8 && 2 * shut > withObject) return median;
  return std::nullopt;
}

}  // namespace mrpt_mapconv::oracle
