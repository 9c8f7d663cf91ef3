#include "DropEdges.h"

#include <cmath>
#include <cstddef>

#include "Traversability.h"

namespace mrpt_mapconv::terrain
{
namespace
{
constexpr double kReach = 2;  // [m]

/** A way straight on from a cell, to one of its 8 neighbours and further. */
struct Way
{
  std::int32_t x, y;    //!< cell that it begins at
  std::int32_t dx, dy;  //!< of a step
};

class DropSearch
{
 public:
  DropSearch(const TerrainLayers& layers, double drop, double maxSlope)
      : m_height(layers.height),
        m_plane(layers.plane),
        m_drop(drop),
        m_maxSlope(maxSlope),
        m_isEdge(layers.height.cells().size(), false)
  {
  }

  std::vector<bool> run()
  {
    const grid::GridFrame& frame = m_height.frame();
    for (std::int32_t y = 0; y < frame.height; ++y)
      for (std::int32_t x = 0; x < frame.width; ++x)
        if (isKnown(x, y) && !isAmidPlane(x, y)) lookAround(x, y);
    return std::move(m_isEdge);
  }

 private:
  bool isInside(std::int32_t x, std::int32_t y) const
  {
    return x >= 0 && y >= 0 && x < m_height.frame().width && y < m_height.frame().height;
  }
  bool isKnown(std::int32_t x, std::int32_t y) const
  {
    return isInside(x, y) && !std::isnan(m_height.at(x, y));
  }
  /** Whether two known cells lie in one plane. */
  bool isOnePlane(std::int32_t x, std::int32_t y, std::int32_t ox, std::int32_t oy) const
  {
    return isInside(ox, oy) && m_plane.at(x, y) == m_plane.at(ox, oy);
  }

  /** Whether all cells around lie in the same plane, as most do. */
  bool isAmidPlane(std::int32_t x, std::int32_t y) const
  {
    const grid::GridFrame& frame = m_plane.frame();
    if (x == 0 || y == 0 || x + 1 == frame.width || y + 1 == frame.height) return false;
    const float* middle = &m_plane.at(x, y);
    bool all = true;
    for (const std::ptrdiff_t row : {-frame.width, 0, frame.width})
      for (std::ptrdiff_t column = -1; column <= 1; ++column)
        all &= middle[row + column] == *middle;
    return all;
  }

  void lookAround(std::int32_t x, std::int32_t y)
  {
    const bool hasPlane = !std::isnan(m_plane.at(x, y));
    for (std::int32_t dy = -1; dy <= 1; ++dy)
      for (std::int32_t dx = -1; dx <= 1; ++dx)
      {
        if (dx == 0 && dy == 0) continue;
        const bool isEnd = hasPlane ? isEndOfPlane(x + dx, y + dy) : !isKnown(x + dx, y + dy);
        if (isEnd) follow({x, y, dx, dy});
      }
  }

  /** Whether a plane ends at a cell beside it, unless another one begins there. */
  bool isEndOfPlane(std::int32_t x, std::int32_t y) const
  {
    return isInside(x, y) && std::isnan(m_plane.at(x, y));
  }

  /** Where the ground leads, per step [m]. */
  double risePerStep(const Way& way, double stride) const
  {
    const std::int32_t x = way.x - way.dx, y = way.y - way.dy;
    if (!isOnePlane(way.x, way.y, x, y)) return -m_maxSlope * stride;
    return static_cast<double>(m_height.at(way.x, way.y)) - static_cast<double>(m_height.at(x, y));
  }

  void follow(const Way& way)
  {
    const double stride = m_height.frame().resolution * (way.dx != 0 && way.dy != 0 ? M_SQRT2 : 1);
    const double own = static_cast<double>(m_height.at(way.x, way.y)),
                 rise = risePerStep(way, stride);
    std::int32_t gap = 0;  // steps to the first cell that nobody saw; 0: none yet
    for (std::int32_t step = 1; step * stride <= kReach; ++step)
    {
      const std::int32_t x = way.x + step * way.dx, y = way.y + step * way.dy;
      if (!isInside(x, y)) return;
      if (!isKnown(x, y))
      {
        if (gap == 0) gap = step;
        continue;
      }
      const bool isLower = own + step * rise - static_cast<double>(m_height.at(x, y)) > m_drop;
      if (gap > 0 && isLower) return mark(way, gap);
      const bool isNoise = gap == 0 && std::isnan(m_plane.at(x, y)) && step * stride <= kEdge;
      if (!isNoise) return;
    }
  }

  void mark(const Way& way, std::int32_t steps)
  {
    for (std::int32_t step = 0; step < steps; ++step)
    {
      const auto x = static_cast<std::size_t>(way.x + step * way.dx),
                 y = static_cast<std::size_t>(way.y + step * way.dy);
      m_isEdge[y * static_cast<std::size_t>(m_height.frame().width) + x] = true;
    }
  }

  const grid::Layer<float>& m_height;
  const grid::Layer<float>& m_plane;
  double m_drop, m_maxSlope;
  std::vector<bool> m_isEdge;
};
}  // namespace

std::vector<bool> dropEdges(const TerrainLayers& layers, double drop, double maxSlope)
{
  return DropSearch(layers, drop, maxSlope).run();
}

}  // namespace mrpt_mapconv::terrain
