#include "StepLayers.h"

#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/GrownFrame.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/params/Require.h>

#include <cmath>
#include <stdexcept>

namespace step_grid
{
using namespace mrpt_mapconv;

namespace
{
constexpr std::size_t kMaxCells = 100'000'000;
constexpr double kFarthest = 1e6;  // [m]

voxel::ColumnSet cellsOf(const std::vector<mrpt::math::TPoint3D>& points, double resolution)
{
  voxel::ColumnSet cells;
  for (const auto& p : points)
  {
    if (!(std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest))
      throw std::runtime_error("a point is more than 1000 km from the origin");
    cells.insert(grid::cellKey(p.x, resolution), grid::cellKey(p.y, resolution));
  }
  return cells;
}
}  // namespace

void StepParams::check() const
{
  params::require(maxStep > 0, "maxStep", maxStep, "> 0 m");
  params::require(maxRange > 0, "maxRange", maxRange, "> 0 m");
}

StepLayers::StepLayers(double resolution)
    : lowest({resolution, 0, 0, 0, 0}, NAN), highest(lowest), occupancy(lowest)
{
}

voxel::ColumnSet StepLayers::insert(const std::vector<mrpt::math::TPoint3D>& points, double maxStep)
{
  const double resolution = lowest.frame().resolution;
  const auto cells = cellsOf(points, resolution);
  makeRoomFor(cells.bounds(resolution));
  for (const auto& p : points)
  {
    const auto i =
        lowest.frame().indexOfKey(grid::cellKey(p.x, resolution), grid::cellKey(p.y, resolution));
    const auto z = static_cast<float>(p.z);
    float &low = lowest.cells()[i], &high = highest.cells()[i];
    low = std::fmin(low, z);
    high = std::fmax(high, z);
    occupancy.cells()[i] = static_cast<double>(high - low) > maxStep ? 1.0f : grid::kFree;
  }
  return cells;
}

void StepLayers::makeRoomFor(const grid::GridFrame& needed)
{
  const grid::GridFrame now = lowest.frame(), least = unite(now, needed);
  if (least == now) return;
  if (least.size() > kMaxCells) throw std::runtime_error("the grid would have too many cells");
  grid::checkGridMapFrame(least);
  const auto frame = grid::grownFrame(
      now, needed, {0.25}, [](const grid::GridFrame& roomy) { return roomy.size() <= kMaxCells; });
  lowest = lowest.onFrame(frame, NAN);
  highest = highest.onFrame(frame, NAN);
  occupancy = occupancy.onFrame(frame, grid::kUnknown);
}

}  // namespace step_grid
