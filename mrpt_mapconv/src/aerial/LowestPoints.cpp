#include "LowestPoints.h"

#include <cmath>
#include <limits>

namespace mrpt_mapconv::aerial
{
using grid::Layer;

namespace
{
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

double squareToCentre(const grid::GridFrame& frame, std::size_t cell, double x, double y)
{
  const auto width = static_cast<std::size_t>(frame.width);
  const double dx = x - frame.centreOf(frame.x0 + static_cast<std::int32_t>(cell % width));
  const double dy = y - frame.centreOf(frame.y0 + static_cast<std::int32_t>(cell / width));
  return dx * dx + dy * dy;
}
}  // namespace

Layer<float> heightsOfCells(const cloud::PointCloud& cloud, const UsedPoints& used,
                            const grid::GridFrame& frame, CollisionRule rule)
{
  Layer<float> heights(frame, kNone);
  std::vector<double> distance;  // of the point that a cell has, squared
  if (rule == CollisionRule::Nearest)
    distance.assign(frame.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i]) continue;
    const std::size_t cell = cellAt(frame, cloud.x[i], cloud.y[i]);
    const auto z = static_cast<float>(cloud.z[i]);
    float& height = heights.cells()[cell];
    if (rule == CollisionRule::Nearest)
    {
      const double square = squareToCentre(frame, cell, cloud.x[i], cloud.y[i]);
      if (square > distance[cell]) continue;
      if (square < distance[cell]) height = z;
      distance[cell] = square;
    }
    if (!(height <= z)) height = z;  // also if there is none
  }
  return heights;
}

}  // namespace mrpt_mapconv::aerial
