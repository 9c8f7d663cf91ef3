#include "FloorAhead.h"

#include <mrpt_mapconv/freespace/RobotLayers.h>
#include <mrpt_mapconv/grid/CellKey.h>

#include <cmath>
#include <limits>

namespace mrpt_mapconv::path
{
namespace
{
using freespace::Layers;

constexpr double kArcSlack = 1e-9;  // of a cell: both ends of the lookahead are included

/** For each point of a path the highest floor within `reach` of arc length before and behind, ends
 * included.
 *
 * \param arc length of the path up to each point, not decreasing [m]
 * \param floors below the points [m]; NaN where there is none
 * \return NaN where no point in reach has a floor */
std::vector<float> highestFloors(const std::vector<double>& arc, const std::vector<float>& floors,
                                 double reach)
{
  std::vector<float> highest(arc.size(), std::numeric_limits<float>::quiet_NaN());
  // Points in the window that may still become the highest: further on and lower, one after
  // another.
  std::vector<std::size_t> candidates;
  std::size_t first = 0, next = 0;
  for (std::size_t i = 0; i < arc.size(); ++i)
  {
    for (; next < arc.size() && arc[next] <= arc[i] + reach; ++next)
    {
      if (std::isnan(floors[next])) continue;
      while (candidates.size() > first && floors[candidates.back()] <= floors[next])
        candidates.pop_back();
      candidates.push_back(next);
    }
    while (first < candidates.size() && arc[candidates[first]] < arc[i] - reach) ++first;
    if (first < candidates.size()) highest[i] = floors[candidates[first]];
  }
  return highest;
}

/** What the heights are counted from below the points; a point without it gets its problem. */
std::vector<float> floorsBelow(std::vector<LiftedPoint>& points, const Layers& layers,
                               freespace::Robot robot)
{
  const grid::GridFrame& frame = layers.frame();
  const grid::Layer<float>& heights = freespace::heightsFor(layers, robot);
  std::vector<float> floors(points.size(), Layers::kNone);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto& at = points[i].position;
    if (at.x < frame.xMin() || at.x >= frame.xMax() || at.y < frame.yMin() || at.y >= frame.yMax())
    {
      points[i].problem = Infeasibility::OffMap;
      continue;
    }
    const std::size_t cell = frame.indexOfKey(grid::cellKey(at.x, frame.resolution),
                                              grid::cellKey(at.y, frame.resolution));
    floors[i] = heights.cells()[cell];
    if (std::isnan(floors[i]))
      points[i].problem = std::isnan(layers.floor.cells()[cell]) ? Infeasibility::NoFloor
                                                                 : Infeasibility::UnseenGround;
  }
  return floors;
}
}  // namespace

void setFloorHeights(DensePath& dense, const Layers& layers, const LiftParams& params)
{
  const std::vector<float> floors = floorsBelow(dense.points, layers, params.robot);
  const std::vector<float> highest =
      highestFloors(dense.arc, floors, params.lookahead + kArcSlack * layers.frame().resolution);
  for (std::size_t i = 0; i < dense.points.size(); ++i)
  {
    LiftedPoint& point = dense.points[i];
    const bool reachable = point.problem == Infeasibility::None;
    point.rule = reachable ? HeightRule::FloorAhead : HeightRule::None;
    point.position.z = reachable ? static_cast<double>(highest[i]) + params.heightOffset
                                 : std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace mrpt_mapconv::path
