#pragma once

#include <mrpt_mapconv/sim/Primitive.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mrpt_mapconv::sim
{
/** A rectangle that is cut into even squares, or nearly so. */
class Tiling
{
 public:
  /** \param side of the squares at most [m] */
  Tiling(const Footprint& area, double side)
      : m_area(area),
        m_across(squares(area.xMax - area.xMin, side)),
        m_along(squares(area.yMax - area.yMin, side))
  {
  }

  const Footprint& area() const { return m_area; }
  std::size_t across() const { return m_across; }  //!< squares along x
  std::size_t along() const { return m_along; }    //!< likewise along y
  std::size_t size() const { return m_across * m_along; }
  /** Where the corner number i, or the square i, begins [m]. */
  double x(std::size_t i) const { return place(m_area.xMin, m_area.xMax, i, m_across); }
  double y(std::size_t j) const { return place(m_area.yMin, m_area.yMax, j, m_along); }
  bool contains(double px, double py) const
  {
    return px >= m_area.xMin && px <= m_area.xMax && py >= m_area.yMin && py <= m_area.yMax;
  }
  std::size_t index(std::size_t i, std::size_t j) const { return j * m_across + i; }

 private:
  static std::size_t squares(double length, double side)
  {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(length / side - 1e-9)));
  }
  static double place(double begin, double end, std::size_t i, std::size_t count)
  {
    return i == count ? end : begin + (end - begin) * double(i) / double(count);
  }

  Footprint m_area;
  std::size_t m_across, m_along;
};

}  // namespace mrpt_mapconv::sim
