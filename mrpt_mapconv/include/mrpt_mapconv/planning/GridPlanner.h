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
  /** From start to goal, both included bit by bit [m]; a single point if they are equal; empty if
   * there is no path. */
  std::vector<mrpt::math::TPoint2D> points;
  std::string problem;  //!< in words, with the place; empty if there is a path
  bool found() const { return problem.empty(); }
};

/** A short way of a disc through the free cells of an occupancy layer, by
 * mrpt::nav::PlannerSimple2D.
 *
 * A cell is passable if it is free and every other cell that is not (occupied, unknown or outside
 * the layer) is at least the robot's radius away, square from square. So the disc keeps clear
 * wherever in the cell its centre is, and a corridor of n cells is wide enough if
 * n ≥ 2·radius/resolution + 1, rounded up to an odd number. The path's straight segments stay
 * inside passable cells and never slip between two cells that touch only at a corner: there is a
 * path if and only if passable cells joined by their sides lead from start to goal.
 *
 * PlannerSimple2D (2.5.8) writes out of bounds for a target outside its map, overwrites what start
 * and goal lie on, inflates by a square but never the two outer rows, cuts corners, and misses
 * neighbouring cells without a third one beside them. Therefore both ends are checked first, it
 * plans with radius 0 on the inflated and padded map, and its path is verified. Its paths are not
 * always shortest, and it gives up on some very long ones; where a flood over the cells' sides
 * finds a shorter way, or the only one, that is taken. Points that a straight segment can leave out
 * are left out. The path is at most √2 times as long as the shortest way over the centres of
 * passable cells by steps to all eight neighbours that cut no corner, plus √2 cells for the ends.
 *
 * Not for two threads at once: PlannerSimple2D keeps static variables.
 *
 * \param occupancy 0 free, (0, 1] occupied, else unknown, which nothing may pass
 * \param robotRadius ≥ 0 [m]
 * \exception std::invalid_argument for an empty layer, places or a radius that are not finite, or
 * a negative radius */
GridPath planOnGrid(const grid::Layer<float>& occupancy, const mrpt::math::TPoint2D& start,
                    const mrpt::math::TPoint2D& goal, double robotRadius);

}  // namespace mrpt_mapconv::planning
