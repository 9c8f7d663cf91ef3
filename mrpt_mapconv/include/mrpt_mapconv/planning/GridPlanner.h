#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::planning
{
/** A planned path, or why there is none. */
struct GridPath
{
  std::vector<mrpt::math::TPoint2D> points;  //!< from start to goal, both included [m]; or empty
  std::string problem;                       //!< in words, with the place; empty if there is a path
  bool found() const { return problem.empty(); }
};

/** Shortest way of a disc through the free cells of an occupancy layer, by
 * mrpt::nav::PlannerSimple2D.
 *
 * That planner (2.5.8) writes out of bounds for a target outside its map, takes occupied start and
 * goal cells for free and does not inflate the two outer rows. Therefore both ends are checked
 * first (inside, and free after inflation), it plans on a copy padded by ceil(radius/resolution)+3
 * unknown cells, and its path is verified against the inflated map.
 *
 * \param occupancy 0 free, (0, 1] occupied, else unknown, which nothing may pass
 * \param robotRadius ≥ 0 [m]; no cell that is not free comes nearer to the robot's centre
 * \exception std::invalid_argument for an empty layer, places or a radius that are not finite, or
 * a negative radius */
GridPath planOnGrid(const grid::Layer<float>& occupancy, const mrpt::math::TPoint2D& start,
                    const mrpt::math::TPoint2D& goal, double robotRadius);

}  // namespace mrpt_mapconv::planning
