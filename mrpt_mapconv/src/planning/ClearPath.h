#pragma once

#include <mrpt/math/TPoint2D.h>

#include <functional>
#include <vector>

#include "PassableCells.h"

namespace mrpt_mapconv::planning
{
/** A point of a path and the cell in which it lies. */
struct Waypoint
{
  Cell cell;
  mrpt::math::TPoint2D point;  //!< [m]
};

/** Whether the straight segment between two points stays in cells of the mask, also where it only
 * touches a side or a corner of a cell (unless both ends lie in one cell). */
bool isClear(const CellMask& mask, const Waypoint& from, const Waypoint& to);

/** Whether all segments of a path are clear. */
bool isClear(const CellMask& mask, const std::vector<Waypoint>& path);

/** Whether the robot may go straight from one point to another. */
using SegmentTest = std::function<bool(const Waypoint& from, const Waypoint& to)>;

/** A path through some of the same points, first and last among them: of each point the farthest
 * is next to which all straight segments from there are clear. Every new segment is clear. */
std::vector<Waypoint> shortened(const SegmentTest& isClear, const std::vector<Waypoint>& path);

double length(const std::vector<Waypoint>& path);  //!< [m]

}  // namespace mrpt_mapconv::planning
