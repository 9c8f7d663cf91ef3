#include <mrpt_mapconv/freespace/Evidence.h>
#include <mrpt_mapconv/freespace/RobotLayers.h>
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

double heightBelow(const grid::Layer<float>& heights, const TPoint3D& at)
{
  const grid::GridFrame& frame = heights.frame();
  return static_cast<double>(heights.cells()[frame.indexOfKey(
      grid::cellKey(at.x, frame.resolution), grid::cellKey(at.y, frame.resolution))]);
}

/** Whether a ground robot has nothing to stand on in a column that has free space. */
bool isUnseenGround(const Layers& layers, const SegmentColumn& column)
{
  const grid::GridFrame& frame = layers.frame();
  if (!frame.containsKey(column.kx, column.ky)) return false;
  const std::size_t cell = frame.indexOfKey(column.kx, column.ky);
  return !std::isnan(layers.floor.cells()[cell]) && std::isnan(layers.support.cells()[cell]);
}

/** What a body meets in a column, as far as the layers alone tell. */
std::optional<HeightRange> outsideFreeRange(const Layers& layers, Robot robot,
                                            const SegmentColumn& column, const HeightRange& body)
{
  const grid::GridFrame& frame = layers.frame();
  if (!frame.containsKey(column.kx, column.ky)) return std::nullopt;
  const std::size_t cell = frame.indexOfKey(column.kx, column.ky);
  if (std::isnan(layers.floor.cells()[cell]))
    return grid::isOccupied(layers.aerial.cells()[cell]) ? std::optional(body) : std::nullopt;
  // between the ground and the free range over it nothing is known to be occupied
  const auto bottom = static_cast<double>(freespace::heightsFor(layers, robot).cells()[cell]);
  if (body.low < bottom - kHeightSlack) return HeightRange{body.low, bottom};
  const auto ceiling = static_cast<double>(layers.ceiling.cells()[cell]);
  // a ground robot stands on the column's own ground, over which there is room for it
  if (robot == Robot::Aerial && body.high > ceiling + kHeightSlack)
    return HeightRange{ceiling, body.high};
  return std::nullopt;
}

/** What of a ground robot must be clear, over what it stands on; empty if it is no higher than what
 * it climbs. */
HeightRange groundBody(const StepLimit& limit, double minClearance)
{
  return {limit.least(), minClearance};
}

/** Calls visit(index of its end, begin, end) for each piece between points that can be reached. */
template <class Visit>
void forEachPiece(const LiftedPath& path, const Visit& visit)
{
  for (std::size_t i = 1; i < path.points.size(); ++i)
    if (path.points[i - 1].problem == Infeasibility::None &&
        path.points[i].problem == Infeasibility::None)
      visit(i, path.points[i - 1].position, path.points[i].position);
}

/** Appends for each piece the first problem in the columns that it crosses.
 * \param problemIn gives a column's, if there is one, without index and place */
template <class ProblemIn>
void addFirstOfPieces(const LiftedPath& path, double resolution, const ProblemIn& problemIn,
                      std::vector<PieceProblem>& found)
{
  forEachPiece(path,
               [&](std::size_t index, const TPoint3D& from, const TPoint3D& to)
               {
                 for (const SegmentColumn& column : columnsOf(from, to, resolution))
                   if (std::optional<PieceProblem> problem = problemIn(column))
                   {
                     const TPoint3D at = (column.from + column.to) * 0.5;
                     problem->index = index;
                     problem->place = {at.x, at.y};
                     found.push_back(*problem);
                     return;
                   }
               });
}

}  // namespace

std::string PieceProblem::inWords() const
{
  char text[240];
  const double x = place.x + shownOrigin.x, y = place.y + shownOrigin.y;
  const double low = from + shownOrigin.z, high = to + shownOrigin.z;
  if (kind == Kind::UnseenGround)
    std::snprintf(text, sizeof(text), "at (%.2f, %.2f): on the straight way between two points, %s",
                  x, y, freespace::evidence::kOpenInWords);
  else if (kind == Kind::Occupied)
    std::snprintf(text, sizeof(text),
                  "at (%.2f, %.2f): the straight way between two points meets something occupied "
                  "between the heights of %.2f m and %.2f m",
                  x, y, low, high);
  else
    std::snprintf(text, sizeof(text),
                  "at (%.2f, %.2f): the %s from %.2f m to %.2f m within %.2f m, more than a ground "
                  "robot can, max(maxStep, a voxel, maxSlope x distance) = %.2f m",
                  x, y,
                  kind == Kind::FloorStep ? (to > from ? "floor rises" : "floor drops")
                                          : (to > from ? "path climbs" : "path descends"),
                  low, high, distance, limit);
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
  if (m_params.robot == Robot::Ground)
  {
    addSteps(path, Kind::FloorStep, found);
    addSteps(path, Kind::HeightStep, found);
    addUnseenGround(path, found);
  }
  addCrossings(path, found);
  for (auto& problem : found) problem.shownOrigin = m_params.shownOrigin;
  return found;
}

void PieceCheck::addSteps(const LiftedPath& path, Kind kind, std::vector<PieceProblem>& found) const
{
  const grid::Layer<float>& ground = freespace::heightsFor(m_layers, m_params.robot);
  const auto heightAt = [&](const TPoint3D& at)
  { return kind == Kind::FloorStep ? heightBelow(ground, at) : at.z; };
  forEachPiece(path,
               [&](std::size_t index, const TPoint3D& from, const TPoint3D& to)
               {
                 const double distance = std::hypot(to.x - from.x, to.y - from.y);
                 const double before = heightAt(from), behind = heightAt(to);
                 if (m_limit.forbids(behind - before, distance))
                   found.push_back({kind,
                                    index,
                                    {to.x, to.y},
                                    before,
                                    behind,
                                    m_limit.counted(distance),
                                    m_limit.at(distance),
                                    {}});
               });
}

void PieceCheck::addUnseenGround(const LiftedPath& path, std::vector<PieceProblem>& found) const
{
  PieceProblem unseen;
  unseen.kind = Kind::UnseenGround;
  addFirstOfPieces(
      path, m_layers.frame().resolution,
      [&](const SegmentColumn& column)
      { return isUnseenGround(m_layers, column) ? std::optional(unseen) : std::nullopt; },
      found);
}

void PieceCheck::addCrossings(const LiftedPath& path, std::vector<PieceProblem>& found) const
{
  const bool ground = m_params.robot == Robot::Ground;
  // from the robot's lowest to its highest part that must be clear, over the path
  const HeightRange body =
      ground ? groundBody(m_limit, m_minClearance) + -m_params.heightOffset : HeightRange{0, 0};
  if (body.empty()) return;
  std::optional<VoxelLookup> voxels;
  if (m_voxels) voxels.emplace(*m_voxels);
  const auto problemIn = [&](const SegmentColumn& column) -> std::optional<PieceProblem>
  {
    const HeightRange swept{std::min(column.from.z, column.to.z) + body.low,
                            std::max(column.from.z, column.to.z) + body.high};
    const auto hit = voxels ? voxels->lowestOccupied(column.kx, column.ky, swept)
                            : outsideFreeRange(m_layers, m_params.robot, column, swept);
    if (!hit) return std::nullopt;
    return PieceProblem{Kind::Occupied, 0, {}, hit->low, hit->high, 0, 0, {}};
  };
  addFirstOfPieces(path, m_layers.frame().resolution, problemIn, found);
}

}  // namespace mrpt_mapconv::path
