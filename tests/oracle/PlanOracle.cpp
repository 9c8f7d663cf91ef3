#include "PlanOracle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <sstream>
#include <tuple>

namespace mrpt_mapconv::test
{
namespace
{
constexpr double kRounding = 1e-8;  // of a cell

/** Distance from a coordinate to the interval [cell, cell + 1]. */
double outside(double coordinate, std::int32_t cell)
{
  return std::max({0.0, cell - coordinate, coordinate - (cell + 1)});
}
}  // namespace

PlanOracle::PlanOracle(const grid::Layer<float>& occupancy, double radius)
    : m_occupancy(occupancy), m_radius(radius), m_passable(occupancy.frame(), 0)
{
  for (std::int32_t iy = 0; iy < occupancy.frame().height; ++iy)
    for (std::int32_t ix = 0; ix < occupancy.frame().width; ++ix)
      m_passable.at(ix, iy) = computePassable(ix, iy);
}

bool PlanOracle::free(std::int32_t ix, std::int32_t iy) const
{
  const auto& frame = m_occupancy.frame();
  return ix >= 0 && iy >= 0 && ix < frame.width && iy < frame.height &&
         m_occupancy.at(ix, iy) == 0.0f;
}

bool PlanOracle::computePassable(std::int32_t ix, std::int32_t iy) const
{
  if (!free(ix, iy)) return false;
  const auto& frame = m_occupancy.frame();
  for (std::int32_t y = -1; y <= frame.height; ++y)  // one ring stands for all that is outside
    for (std::int32_t x = -1; x <= frame.width; ++x)
    {
      const double gap =
          std::hypot(std::max(0, std::abs(x - ix) - 1), std::max(0, std::abs(y - iy) - 1));
      if (!free(x, y) && gap * frame.resolution < m_radius - kRounding * frame.resolution)
        return false;
    }
  return true;
}

bool PlanOracle::passable(std::int32_t ix, std::int32_t iy) const
{
  return free(ix, iy) && m_passable.at(ix, iy) != 0;
}

double PlanOracle::shortestWay(std::int32_t fromX, std::int32_t fromY, std::int32_t toX,
                               std::int32_t toY) const
{
  using Entry = std::tuple<double, std::int32_t, std::int32_t>;
  grid::Layer<double> distance(m_occupancy.frame(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance.at(fromX, fromY) = 0;
  for (queue.emplace(0, fromX, fromY); !queue.empty();)
  {
    const auto [d, x, y] = queue.top();
    queue.pop();
    if (d > distance.at(x, y)) continue;
    for (std::int32_t dy = -1; dy <= 1; ++dy)
      for (std::int32_t dx = -1; dx <= 1; ++dx)
      {
        if (!passable(x + dx, y + dy) || !passable(x + dx, y) || !passable(x, y + dy)) continue;
        const double next = d + m_occupancy.frame().resolution * std::hypot(dx, dy);
        if (next >= distance.at(x + dx, y + dy)) continue;
        distance.at(x + dx, y + dy) = next;
        queue.emplace(next, x + dx, y + dy);
      }
  }
  return distance.at(toX, toY);
}

std::string PlanOracle::faultAt(const mrpt::math::TPoint2D& place) const
{
  const auto& frame = m_occupancy.frame();
  const double x = place.x / frame.resolution - frame.x0;
  const double y = place.y / frame.resolution - frame.y0;
  std::ostringstream text;
  text << "at " << place.x << ", " << place.y << ": ";
  const auto near = [&](std::int32_t ix, std::int32_t iy)
  { return std::hypot(outside(x, ix), outside(y, iy)); };
  bool inside = false;
  for (std::int32_t iy = -1; iy <= frame.height; ++iy)
    for (std::int32_t ix = -1; ix <= frame.width; ++ix)
    {
      inside = inside || (passable(ix, iy) && near(ix, iy) <= kRounding);
      if (free(ix, iy) || near(ix, iy) >= m_radius / frame.resolution - kRounding) continue;
      text << "nearer than the radius to cell " << ix << ", " << iy;
      return text.str();
    }
  if (inside) return {};
  text << "not in a passable cell";
  return text.str();
}

std::string PlanOracle::fault(const std::vector<mrpt::math::TPoint2D>& path) const
{
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const auto& from = path[i == 0 ? 0 : i - 1];
    const auto way = path[i] - from;
    const int steps = 1 + static_cast<int>(100 * way.norm() / m_occupancy.frame().resolution);
    for (int s = 0; s <= steps; ++s)
      if (const auto found = faultAt(from + way * (static_cast<double>(s) / steps)); !found.empty())
        return "segment " + std::to_string(i) + " " + found;
  }
  return {};
}

}  // namespace mrpt_mapconv::test
