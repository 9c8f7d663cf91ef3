#include "DropWalk.h"

#include <mrpt_mapconv/freespace/DropEdges.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <cmath>

#include "FloorTile.h"
#include "SupportRules.h"

namespace mrpt_mapconv::freespace
{
namespace
{
constexpr double kReach = 1.0;  // [m]

std::int32_t stepsWithin(double metres, double step)
{
  constexpr double kSlack = 1e-6;
  return static_cast<std::int32_t>(std::min(metres / step + kSlack, 1e6));
}
}  // namespace

DropWalk::DropWalk(const ConversionParams& params, const Layers& layers)
    : m_layers(layers),
      m_isOn(params.looksForSteps() && params.floorFrom == FloorFrom::Seen),
      m_most(kSupportUnits * (params.maxStepVoxels(layers.frame().resolution) + 1)),
      m_straight(stepsWithin(kReach, layers.frame().resolution)),
      m_diagonal(stepsWithin(kReach, std::sqrt(2.0) * layers.frame().resolution)),
      m_unitsPerMetre(kSupportUnits * (1.0 / layers.frame().resolution))
{
}

bool DropWalk::leadsDown(std::int32_t ix, std::int32_t iy, std::int32_t dx, std::int32_t dy,
                         std::int32_t support) const
{
  const grid::GridFrame& frame = m_layers.frame();
  const std::int32_t last = dx != 0 && dy != 0 ? m_diagonal : m_straight;
  for (std::int32_t k = 1; k <= last; ++k)
  {
    const std::int32_t x = ix + k * dx, y = iy + k * dy;
    if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) return false;
    const float floor = m_layers.floor.at(x, y);
    if (std::isnan(floor)) return false;
    if (support - heightKey(floor, m_unitsPerMetre) > m_most) return true;
    if (!std::isnan(m_layers.support.at(x, y))) return false;
  }
  return false;
}

bool DropWalk::isEdge(std::int32_t ix, std::int32_t iy) const
{
  const float height = m_layers.support.at(ix, iy);
  if (!m_isOn || std::isnan(height)) return false;
  const std::int32_t support = heightKey(height, m_unitsPerMetre);
  for (std::int32_t dy = -1; dy <= 1; ++dy)
    for (std::int32_t dx = -1; dx <= 1; ++dx)
      if ((dx != 0 || dy != 0) && leadsDown(ix, iy, dx, dy, support)) return true;
  return false;
}

grid::Layer<float> dropEdges(const Layers& layers, const ConversionParams& params)
{
  grid::Layer<float> edges(layers.frame(), 0);
  const DropWalk walk(params, layers);
  for (std::int32_t iy = 0; iy < layers.frame().height && walk.isOn(); ++iy)
    for (std::int32_t ix = 0; ix < layers.frame().width; ++ix)
      if (grid::isOccupied(layers.ground.at(ix, iy)) && walk.isEdge(ix, iy)) edges.at(ix, iy) = 1;
  return edges;
}

}  // namespace mrpt_mapconv::freespace
