#include <mrpt_mapconv/freespace/Layers.h>

#include <cmath>

namespace mrpt_mapconv::freespace
{
Layers Layers::onFrame(const grid::GridFrame& frame) const
{
  Layers out;
  out.floor = floor.onFrame(frame, kNone);
  out.ceiling = ceiling.onFrame(frame, kNone);
  out.slope = slope.onFrame(frame, kNone);
  out.aerial = aerial.onFrame(frame, grid::kUnknown);
  out.ground = ground.onFrame(frame, grid::kUnknown);
  return out;
}

LayerStatistics statistics(const Layers& layers)
{
  LayerStatistics count;
  for (std::size_t i = 0; i < layers.aerial.cells().size(); ++i)
  {
    const float aerial = layers.aerial.cells()[i];
    if (grid::isFree(aerial))
    {
      ++count.free;
      count.steep += grid::isOccupied(layers.ground.cells()[i]);
      count.slopeUnknown += std::isnan(layers.slope.cells()[i]);
    }
    else if (grid::isOccupied(aerial))
      ++count.occupied;
    else
      ++count.unknown;
  }
  return count;
}

}  // namespace mrpt_mapconv::freespace
