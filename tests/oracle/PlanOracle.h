#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::test
{
/** Slow and obviously right answers about ways of a disc through an occupancy layer. */
class PlanOracle
{
 public:
  /** \param radius of the robot [m] */
  PlanOracle(const grid::Layer<float>& occupancy, double radius);

  /** Whether a cell is free and no other that is not free, or not on the layer, has a square
   * nearer than the radius to this one's. */
  bool passable(std::int32_t ix, std::int32_t iy) const;

  /** Length [m] of the shortest way between two cells' centres by steps to the eight neighbours,
   * diagonal ones only between two passable cells; infinite if there is none. */
  double shortestWay(std::int32_t fromX, std::int32_t fromY, std::int32_t toX,
                     std::int32_t toY) const;

  /** What is wrong with a path: a disc that overlaps a cell that is not free (or not on the layer)
   * or a place in a cell that is not passable, every hundredth of a cell; empty if nothing. */
  std::string fault(const std::vector<mrpt::math::TPoint2D>& path) const;

 private:
  bool free(std::int32_t ix, std::int32_t iy) const;
  bool computePassable(std::int32_t ix, std::int32_t iy) const;
  std::string faultAt(const mrpt::math::TPoint2D& place) const;

  grid::Layer<float> m_occupancy;
  double m_radius;
  grid::Layer<char> m_passable;
};

}  // namespace mrpt_mapconv::test
