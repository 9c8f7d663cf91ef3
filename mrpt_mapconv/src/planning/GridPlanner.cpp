#include <mrpt_mapconv/planning/GridPlanner.h>

#include "GridSearch.h"

namespace mrpt_mapconv::planning
{
GridPath planOnGrid(const grid::Layer<float>& occupancy, const mrpt::math::TPoint2D& start,
                    const mrpt::math::TPoint2D& goal, double robotRadius)
{
  return GridSearch(occupancy, start, goal, robotRadius).plan();
}

}  // namespace mrpt_mapconv::planning
