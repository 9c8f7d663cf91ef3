#include "FloorSteps.h"

#include <mrpt_mapconv/grid/CellKey.h>

#include <cmath>

#include "../path/Densify.h"

namespace mrpt_mapconv::planning
{
namespace
{
using grid::Layer;

/** Whether floor steps are low enough on the straight way between two points. */
bool isEven(const Layer<float>& floor, const path::StepLimit& limit, const Waypoint& from,
            const Waypoint& to)
{
  const grid::GridFrame& frame = floor.frame();
  const auto dense = path::densify({from.point, to.point}, frame.resolution);
  for (std::size_t i = 1; i < dense.points.size(); ++i)
  {
    const auto floorAt = [&](const path::LiftedPoint& point)
    {
      const auto& at = point.position;
      return static_cast<double>(floor.cells()[frame.indexOfKey(
          grid::cellKey(at.x, frame.resolution), grid::cellKey(at.y, frame.resolution))]);
    };
    const double change = floorAt(dense.points[i]) - floorAt(dense.points[i - 1]);
    if (limit.forbids(change, dense.arc[i] - dense.arc[i - 1])) return false;
  }
  return true;
}
}  // namespace

void blockFloorSteps(const grid::Layer<float>& floor, const path::StepLimit& limit,
                     GridSearch& search)
{
  const grid::GridFrame& frame = floor.frame();
  const auto look = [&](Cell a, Cell b)
  {
    if (!holds(search.passable(), b)) return;
    const double change = static_cast<double>(floor.at(b.x, b.y) - floor.at(a.x, a.y));
    if (!limit.forbids(change, frame.resolution)) return;
    if (a.x == b.x || a.y == b.y) return search.blockSide(a, b);
    search.testSegmentsIn(a);
    search.testSegmentsIn(b);
  };
  search.setSegmentTest([&floor, limit](const Waypoint& from, const Waypoint& to)
                        { return isEven(floor, limit, from, to); });
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      if (const Cell cell{ix, iy}; holds(search.passable(), cell))
        for (const Cell& next :
             {Cell{ix + 1, iy}, {ix - 1, iy + 1}, {ix, iy + 1}, {ix + 1, iy + 1}})
          look(cell, next);
}

}  // namespace mrpt_mapconv::planning
