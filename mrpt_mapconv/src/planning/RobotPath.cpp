#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/planning/RobotPath.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <tuple>

#include "ClimbCheck.h"
#include "GridSearch.h"

namespace mrpt_mapconv::planning
{
namespace
{
using mrpt::math::TPoint2D;
using path::LiftedPath;

/** What is wrong with a point of a path, without its number. */
std::string placeAndReason(const LiftedPath& path, std::size_t index)
{
  const std::string text = path.describeProblem(index);
  return text.empty() ? text : text.substr(text.find("at ("));
}

/** Plans and lifts in turns; what does not fit narrows the next search. */
class RobotPlanner
{
 public:
  RobotPlanner(const freespace::Layers& layers, const freespace::ConversionParams& conversion,
               const RobotPathQuery& query, const voxel::VoxelSource* voxels)
      : m_layers(layers),
        m_conversion(conversion),
        m_query(query),
        m_voxels(voxels),
        m_search(query.lift.robot == freespace::Robot::Ground ? layers.ground : layers.aerial,
                 query.start, query.goal, query.robotRadius),
        m_looked(layers.frame(), 0)
  {
  }

  RobotPath plan()
  {
    for (int attempt = 0; attempt < m_query.mostAttempts; ++attempt)
    {
      const GridPath way = m_search.plan();
      if (!way.found()) return without(m_firstMisfit.empty() ? way.problem : blockedWay());
      const LiftedPath path = lift(way.points);
      const std::size_t climb = path.feasible() ? blockedClimb(path) : 0;
      if (path.feasible() && climb == 0) return {path, lengthOf(way.points), {}};
      if (const std::string problem = problemOfEnds(path); !problem.empty())
        return without(problem);
      if (m_firstMisfit.empty())
        m_firstMisfit =
            climb > 0 ? climbInWords(path, climb) : placeAndReason(path, *path.firstProblem());
      if (climb == 0)
        learnFrom(path);
      else if (!avoidClimb(path, climb))
        return without(blockedWay());
    }
    return without("no path in 3D among the first " + std::to_string(m_query.mostAttempts) +
                   " that were tried, there may be another; what was wrong with the first, " +
                   m_firstMisfit);
  }

 private:
  static RobotPath without(const std::string& problem) { return {{}, 0, problem}; }

  static double lengthOf(const std::vector<TPoint2D>& points)
  {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    return length;
  }

  LiftedPath lift(const std::vector<TPoint2D>& points) const
  {
    return path::liftPath(points, m_layers, m_conversion, m_query.lift, m_voxels);
  }

  LiftedPath liftCentre(Cell cell) const
  {
    const grid::GridFrame& frame = m_layers.frame();
    return lift({{(frame.x0 + cell.x + 0.5) * frame.resolution,
                  (frame.y0 + cell.y + 0.5) * frame.resolution}});
  }

  /** \param place on the layers [m] */
  Cell cellOf(double x, double y) const
  {
    const grid::GridFrame& frame = m_layers.frame();
    return {grid::cellKey(x, frame.resolution) - frame.x0,
            grid::cellKey(y, frame.resolution) - frame.y0};
  }

  /** Why there is no path whatever lies between; empty if the ends are good. */
  std::string problemOfEnds(const LiftedPath& path) const
  {
    const std::size_t last = path.points.size() - 1;
    for (const auto& [name, place, index] :
         {std::tuple{"start", m_query.start, std::size_t{0}}, {"goal", m_query.goal, last}})
    {
      if (const auto problem = placeAndReason(path, index); !problem.empty())
        return name + (" " + problem);
      const LiftedPath centre = liftCentre(cellOf(place.x, place.y));
      if (!centre.feasible())
        return name + (": the centre of its cell, " + placeAndReason(centre, 0));
    }
    return {};
  }

  std::string blockedWay() const
  {
    return (m_avoidedClimb ? "no path in 3D was found, though there is a way in 2D; "
                           : "there is a way in 2D, but not in 3D: ") +
           m_firstMisfit;
  }

  /** The point of a feasible path that the robot cannot reach from the one before; 0 if there is
   * none. */
  std::size_t blockedClimb(const LiftedPath& path) const
  {
    if (m_query.lift.robot == freespace::Robot::Ground) return 0;
    return ClimbCheck(m_layers, m_conversion, m_query.lift, m_voxels).firstBlocked(path);
  }

  static std::string climbInWords(const LiftedPath& path, std::size_t index)
  {
    const auto &from = path.points[index - 1].position, &to = path.points[index].position;
    char text[160];
    std::snprintf(text, sizeof(text),
                  "at (%.2f, %.2f): something is in the way between the heights of %.2f m and "
                  "%.2f m",
                  to.x, to.y, from.z, to.z);
    return text;
  }

  /** Leads the next way elsewhere. \return false if there is nothing left to try */
  bool avoidClimb(const LiftedPath& path, std::size_t index)
  {
    const auto &from = path.points[index - 1].position, &to = path.points[index].position;
    const Cell start = cellOf(m_query.start.x, m_query.start.y);
    const Cell goal = cellOf(m_query.goal.x, m_query.goal.y);
    const Cell cells[] = {cellOf(to.x, to.y), cellOf(from.x, from.y)};
    m_avoidedClimb = true;
    if (m_search.isOpen(cells[0]) || m_search.isOpen(cells[1]))
    {
      for (const Cell& cell : cells) m_search.keepToCentre(cell);
      return true;
    }
    // from centre to centre it does not work either; which heights come before is up to the way
    for (const Cell& cell : cells)
      if (cell != start && cell != goal)
      {
        m_search.exclude(cell);
        return true;
      }
    return false;
  }

  void learnFrom(const LiftedPath& path)
  {
    std::vector<Cell> misfits;
    for (const auto& point : path.points)
    {
      if (point.problem == path::Infeasibility::None) continue;
      const Cell cell = cellOf(point.position.x, point.position.y);
      lookAt(cell, misfits);
      m_search.keepToCentre(cell);
    }
    excludeAround(misfits);
  }

  /** Excludes a cell if the robot does not fit in its centre, and appends it to the misfits. */
  void lookAt(Cell cell, std::vector<Cell>& misfits)
  {
    if (!holds(m_search.passable(), cell) || holds(m_looked, cell)) return;
    m_looked.at(cell.x, cell.y) = 1;
    if (liftCentre(cell).feasible()) return;
    m_search.exclude(cell);
    misfits.push_back(cell);
  }

  /** Excludes more misfits around those known, since they come in patches. */
  void excludeAround(std::vector<Cell>& misfits)
  {
    constexpr std::size_t kMost = 10'000;  // so that an attempt stays quick in a hopeless map
    for (std::size_t i = 0; i < misfits.size() && misfits.size() < kMost; ++i)
    {
      const Cell centre = misfits[i];
      for (std::int32_t dy = -1; dy <= 1; ++dy)
        for (std::int32_t dx = -1; dx <= 1; ++dx) lookAt({centre.x + dx, centre.y + dy}, misfits);
    }
  }

  const freespace::Layers& m_layers;
  const freespace::ConversionParams& m_conversion;
  const RobotPathQuery& m_query;
  const voxel::VoxelSource* m_voxels;
  GridSearch m_search;
  CellMask m_looked;  //!< cells whose centre was tried
  std::string m_firstMisfit;
  bool m_avoidedClimb = false;
};

}  // namespace

RobotPath planRobotPath(const freespace::Layers& layers,
                        const freespace::ConversionParams& conversion, const RobotPathQuery& query,
                        const voxel::VoxelSource* voxels)
{
  if (query.mostAttempts < 1)
    throw std::invalid_argument("plan: mostAttempts = " + std::to_string(query.mostAttempts) +
                                " is not valid: it must be at least 1");
  return RobotPlanner(layers, conversion, query, voxels).plan();
}

}  // namespace mrpt_mapconv::planning
