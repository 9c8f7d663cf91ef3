#include "OccupancyLook.h"

#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <array>

namespace mrpt_mapconv::grid::picture
{
namespace
{
struct Description
{
  TColor color;
  const char* meaning;
};

const Description& descriptionOf(OccupancyLook look)
{
  static const std::array<Description, 7> all{
      {{kUnknownColor, "unknown"},
       {kFreeColor, "free"},
       {kInferredColor, "free, ground inferred from what was seen around"},
       {kFrontierColor, "frontier: free for a flying robot, but its ground was not seen"},
       {kSteepColor, "too steep or too high a step (free for a flying robot)"},
       {kOccupiedColor, "occupied"},
       {kDropColor, "edge where the ground falls away: of a drop, or of what stands there"}}};
  return all.at(static_cast<std::size_t>(look));
}
}  // namespace

OccupancyLook lookOf(const StyledLayer& occupancy, std::int32_t x, std::int32_t y)
{
  using Look = OccupancyLook;
  const float value = occupancy.layer->at(x, y);
  if (!occupancy.freeFor)
    return isOccupied(value) ? Look::Occupied : isFree(value) ? Look::Free : Look::Unknown;
  const bool isFreeForOthers = isFree(occupancy.freeFor->at(x, y));
  if (isOccupied(value))
  {
    if (occupancy.drops && occupancy.drops->at(x, y) != 0) return Look::Drop;
    return isFreeForOthers ? Look::Steep : Look::Occupied;
  }
  if (isFree(value))
    return occupancy.evidence && occupancy.evidence->at(x, y) == kInferredGround ? Look::Inferred
                                                                                 : Look::Free;
  return occupancy.evidence && isFreeForOthers ? Look::Frontier : Look::Unknown;
}

bool hasLook(const StyledLayer& occupancy, OccupancyLook look)
{
  const GridFrame& frame = occupancy.layer->frame();
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
      if (lookOf(occupancy, x, y) == look) return true;
  return false;
}

const TColor& colorOf(OccupancyLook look) { return descriptionOf(look).color; }
const char* meaningOf(OccupancyLook look) { return descriptionOf(look).meaning; }

}  // namespace mrpt_mapconv::grid::picture
