#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "Densify.h"
#include "FloorAhead.h"
#include "InferredLength.h"
#include "NearestHeight.h"
#include "SlabMap.h"
#include "SphereFit.h"

namespace mrpt_mapconv::path
{
namespace
{
using freespace::Layers;

struct CellPlace
{
  std::int32_t kx, ky;
};

CellPlace cellOf(const LiftedPoint& point, const grid::GridFrame& frame)
{
  return {grid::cellKey(point.position.x, frame.resolution),
          grid::cellKey(point.position.y, frame.resolution)};
}

void checkPath(const std::vector<mrpt::math::TPoint2D>& path)
{
  for (std::size_t i = 0; i < path.size(); ++i)
    if (!std::isfinite(path[i].x) || !std::isfinite(path[i].y))
    {
      std::ostringstream message;
      message << "path point " << i << " = (" << path[i].x << ", " << path[i].y
              << ") is not valid: both coordinates must be finite";
      throw std::invalid_argument(message.str());
    }
}

void checkMaps(const Layers& layers, const voxel::VoxelSource* voxels)
{
  const grid::GridFrame& frame = layers.frame();
  if (frame.empty() || !(frame.resolution > 0))
    throw std::invalid_argument("layers: they are empty, a path needs at least one cell");
  for (const auto& [name, layer] : layers.named())
    if (layer->frame() != frame)
      throw std::invalid_argument("layers: " + name + " and floor must be on one frame");
  if (voxels && voxels->resolution() != frame.resolution)
  {
    std::ostringstream message;
    message << "voxel map: its resolution is " << voxels->resolution() << " m, the layers' "
            << frame.resolution << " m; it must be the map that the layers were made of";
    throw std::invalid_argument(message.str());
  }
}

void setProblem(LiftedPoint& point, Infeasibility problem)
{
  point.problem = problem;
  point.rule = HeightRule::None;
  point.position.z = std::numeric_limits<double>::quiet_NaN();
}

/** Moves the points of an aerial robot's path until its sphere is clear. */
class SphereLift
{
 public:
  SphereLift(const Layers& layers, double radius)
      : m_layers(layers), m_disc(layers.frame(), radius), m_fit(layers, m_disc)
  {
  }

  /** Reads the slabs near the path. */
  void readSlabs(const std::vector<LiftedPoint>& points, const voxel::VoxelSource& voxels,
                 std::int32_t minRun)
  {
    const std::optional<voxel::KeyRect> rect = cellsNear(points);
    if (!rect) return;
    ColumnMarks columns(*rect);
    for (const LiftedPoint& point : points)
    {
      if (point.problem != Infeasibility::None) continue;
      moveTo(point);
      m_disc.forEachRow([&](const Disc::Row& row)
                        { columns.mark(row.ky, row.kxBegin, row.kxEnd); });
    }
    m_slabs.emplace(voxels, m_layers, minRun, columns);
  }

  void lift(LiftedPoint& point, bool unknownIsPassable)
  {
    moveTo(point);
    const SphereLimits limits = m_fit.limits();
    if (!limits.allCellsHaveRun)
    {
      const Obstacle obstacle = m_fit.obstacle(unknownIsPassable);
      point.obstacle = obstacle.centre;
      if (obstacle.kind != Infeasibility::None) return setProblem(point, obstacle.kind);
    }
    m_forbidden.clear();
    std::optional<RuledHeight> height = nearestHeight(point.position.z, limits, m_forbidden);
    if (height && m_slabs)
    {
      forbidSlabs(height->z, height->z);
      if (!m_forbidden.empty())
      {
        forbidSlabs(limits.low, limits.high);
        height = nearestHeight(point.position.z, limits, m_forbidden);
      }
    }
    if (!height) return setProblem(point, Infeasibility::NoHeight);
    point.position.z = height->z;
    point.rule = height->rule;
  }

 private:
  void moveTo(const LiftedPoint& point)
  {
    const CellPlace cell = cellOf(point, m_layers.frame());
    m_disc.moveTo(point.position.x, point.position.y, cell.kx, cell.ky);
  }

  /** The smallest rectangle of the frame that holds all cells near the points. */
  std::optional<voxel::KeyRect> cellsNear(const std::vector<LiftedPoint>& points) const
  {
    const grid::GridFrame& frame = m_layers.frame();
    voxel::KeyRect rect{frame.xEnd(), frame.yEnd(), frame.x0, frame.y0};
    bool any = false;
    for (const LiftedPoint& point : points)
    {
      if (point.problem != Infeasibility::None) continue;
      const CellPlace cell = cellOf(point, frame);
      const std::int32_t reach = m_disc.reach();
      any = true;
      rect.xMin = std::min(rect.xMin, std::max(cell.kx - reach, frame.x0));
      rect.yMin = std::min(rect.yMin, std::max(cell.ky - reach, frame.y0));
      rect.xMax = std::max(rect.xMax, std::min(cell.kx + reach, frame.xEnd() - 1));
      rect.yMax = std::max(rect.yMax, std::min(cell.ky + reach, frame.yEnd() - 1));
    }
    return any ? std::optional(rect) : std::nullopt;
  }

  /** Adds what the slabs in reach forbid, as far as that overlaps the heights low … high. */
  void forbidSlabs(double low, double high)
  {
    const double lowest = low - m_disc.radius(), highest = high + m_disc.radius();
    const auto look = [&](const Disc::Row& row, const Slab& slab)
    {
      const double half = m_fit.halfHeight(row, slab.kx);
      const ForbiddenHeights range{slab.bottom - half, slab.top + half};
      if (range.top > low && range.bottom < high) forbid(range, m_forbidden);
    };
    m_disc.forEachRow(
        [&](const Disc::Row& row)
        {
          m_slabs->forEach(row.ky, row.kxBegin, row.kxEnd, lowest, highest,
                           [&](const Slab& slab) { look(row, slab); });
        });
  }

  const Layers& m_layers;
  Disc m_disc;
  SphereFit m_fit;
  std::optional<SlabMap> m_slabs;
  std::vector<ForbiddenHeights> m_forbidden;
};

}  // namespace

LiftedPath liftPath(const std::vector<mrpt::math::TPoint2D>& path, const Layers& layers,
                    const freespace::ConversionParams& conversion, const LiftParams& params,
                    const voxel::VoxelSource* voxels)
{
  conversion.check();
  params.check(conversion.minClearance);
  checkMaps(layers, voxels);
  checkPath(path);

  DensePath dense = densify(path, layers.frame().resolution);
  setFloorHeights(dense, layers, params);
  LiftedPath lifted;
  lifted.shownOrigin = params.shownOrigin;
  if (params.robot == freespace::Robot::Aerial)
  {
    SphereLift sphere(layers, params.safetyRadius);
    lifted.slabsChecked = voxels != nullptr;
    if (voxels)
      sphere.readSlabs(dense.points, voxel::FilledSource(*voxels, conversion.reading),
                       conversion.minRunVoxels(layers.frame().resolution));
    for (LiftedPoint& point : dense.points)
      if (point.problem == Infeasibility::None) sphere.lift(point, params.unknownIsPassable);
  }
  else
    lifted.inferredLength = inferredLength(dense.points, layers);
  lifted.points = std::move(dense.points);
  return lifted;
}

}  // namespace mrpt_mapconv::path
