#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/path/PieceCheck.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "NearestHeight.h"
#include "SegmentColumns.h"
#include "VoxelLookup.h"

namespace mrpt_mapconv::path
{
namespace
{
using freespace::Layers;
using freespace::Robot;
using mrpt::math::TPoint3D;
using Kind = PieceProblem::Kind;

/** Heights, upwards [m]. */
struct HeightRange
{
  double low, high;
};

double floorBelow(const Layers& layers, const TPoint3D& at)
{
  const grid::GridFrame& frame = layers.frame();
  return static_cast<double>(layers.floor.cells()[frame.indexOfKey(
      grid::cellKey(at.x, frame.resolution), grid::cellKey(at.y, frame.resolution))]);
}

/** What of the voxels [low, high] in a column is occupied; nothing if none is. */
std::optional<HeightRange> occupiedVoxel(VoxelLookup& voxels, double resolution,
                                         const SegmentColumn& column, const HeightRange& body)
{
  const auto begin = static_cast<std::int32_t>(std::floor((body.low + kHeightSlack) / resolution));
  const auto end = static_cast<std::int32_t>(std::ceil((body.high - kHeightSlack) / resolution));
  const auto found = voxels.lowestOccupied(column.kx, column.ky, begin, end);
  if (!found) return std::nullopt;
  return HeightRange{*found * resolution, (*found + 1) * resolution};
}

/** The same by the layers alone. */
std::optional<HeightRange> outsideFreeRange(const Layers& layers, Robot robot,
                                            const SegmentColumn& column, const HeightRange& body)
{
  const grid::GridFrame& frame = layers.frame();
  if (!frame.containsKey(column.kx, column.ky)) return std::nullopt;
  const std::size_t cell = frame.indexOfKey(column.kx, column.ky);
  const auto floor = static_cast<double>(layers.floor.cells()[cell]);
  if (std::isnan(floor))
    return grid::isOccupied(layers.aerial.cells()[cell]) ? std::optional(body) : std::nullopt;
  if (body.low < floor - kHeightSlack) return HeightRange{body.low, floor};
  const auto ceiling = static_cast<double>(layers.ceiling.cells()[cell]);
  // a ground robot stands on the column's own floor, over which there is room for it
  if (robot == Robot::Aerial && body.high > ceiling + kHeightSlack)
    return HeightRange{ceiling, body.high};
  return std::nullopt;
}

}  // namespace

std::string PieceProblem::inWords() const
{
  char text[240];
  if (kind == Kind::Occupied)
    std::snprintf(text, sizeof(text),
                  "at (%.2f, %.2f): the straight way between two points meets something occupied "
                  "between the heights of %.2f m and %.2f m",
                  place.x, place.y, from, to);
  else
    std::snprintf(text, sizeof(text),
                  "at (%.2f, %.2f): the %s from %.2f m to %.2f m within %.2f m, more than a ground "
                  "robot can, max(maxStep, a voxel, maxSlope x distance) = %.2f m",
                  place.x, place.y,
                  kind == Kind::FloorStep ? (to > from ? "floor rises" : "floor drops")
                                          : (to > from ? "path climbs" : "path descends"),
                  from, to, distance, limit);
  return text;
}

PieceCheck::PieceCheck(const Layers& layers, const freespace::ConversionParams& conversion,
                       const LiftParams& params, const voxel::VoxelSource* voxels)
    : m_layers(layers),
      m_minClearance(conversion.minClearance),
      m_params(params),
      m_voxels(voxels),
      m_limit(conversion, layers.frame().resolution)
{
}

std::vector<PieceProblem> PieceCheck::problems(const LiftedPath& path) const
{
  std::vector<PieceProblem> found;
  const auto forEachPiece = [&](const auto& visit)
  {
    for (std::size_t i = 1; i < path.points.size(); ++i)
      if (path.points[i - 1].problem == Infeasibility::None &&
          path.points[i].problem == Infeasibility::None)
        visit(i, path.points[i - 1].position, path.points[i].position);
  };
  const auto addSteps = [&](Kind kind, const auto& heightAt)
  {
    forEachPiece(
        [&](std::size_t index, const TPoint3D& from, const TPoint3D& to)
        {
          const double distance = std::hypot(to.x - from.x, to.y - from.y);
          const double low = heightAt(from), high = heightAt(to);
          if (m_limit.forbids(high - low, distance))
            found.push_back({kind, index, {to.x, to.y}, low, high, distance, m_limit.at(distance)});
        });
  };
  const bool ground = m_params.robot == Robot::Ground;
  if (ground)
  {
    addSteps(Kind::FloorStep, [&](const TPoint3D& at) { return floorBelow(m_layers, at); });
    addSteps(Kind::HeightStep, [](const TPoint3D& at) { return at.z; });
  }

  // from the robot's lowest to its highest part, over the path's height
  const HeightRange body = ground ? HeightRange{m_limit.least() - m_params.heightOffset,
                                                m_minClearance - m_params.heightOffset}
                                  : HeightRange{0, 0};
  const double resolution = m_layers.frame().resolution;
  std::optional<VoxelLookup> voxels;
  if (m_voxels) voxels.emplace(*m_voxels);
  forEachPiece(
      [&](std::size_t index, const TPoint3D& from, const TPoint3D& to)
      {
        for (const SegmentColumn& column : columnsOf(from, to, resolution))
        {
          const HeightRange heights{std::min(column.from.z, column.to.z) + body.low,
                                    std::max(column.from.z, column.to.z) + body.high};
          if (body.low > body.high) return;  // a robot no higher than what it climbs
          const auto hit = voxels ? occupiedVoxel(*voxels, resolution, column, heights)
                                  : outsideFreeRange(m_layers, m_params.robot, column, heights);
          if (!hit) continue;
          const TPoint3D middle = (column.from + column.to) * 0.5;
          found.push_back({Kind::Occupied, index, {middle.x, middle.y}, hit->low, hit->high, 0, 0});
          return;
        }
      });
  return found;
}

}  // namespace mrpt_mapconv::path
