#include "WhyNotFree.h"

#include <mrpt_mapconv/freespace/Evidence.h>
#include <mrpt_mapconv/freespace/RobotLayers.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/params/Text.h>

#include <cmath>
#include <sstream>

#include "../freespace/DropWalk.h"

namespace mrpt_mapconv::planning
{
std::string whyNotFree(const freespace::Layers& layers,
                       const freespace::ConversionParams& conversion, freespace::Robot robot,
                       Cell cell)
{
  if (grid::isFree(freespace::occupancyFor(layers, robot).at(cell.x, cell.y))) return {};
  const float aerial = layers.aerial.at(cell.x, cell.y);
  std::ostringstream text;
  if (!grid::isFree(aerial))
    text << (grid::isOccupied(aerial) ? "no free range there is"
                                      : "no free range is known there that is")
         << " minClearance = " << conversion.minClearance << " m high";
  else if (std::isnan(layers.support.at(cell.x, cell.y)))
    text << freespace::evidence::kOpenInWords;
  else if (const float slope = layers.slope.at(cell.x, cell.y); std::isnan(slope))
    text << "the slope there is not known";
  else if (static_cast<double>(slope) > conversion.maxSlope || conversion.maxStep <= 0)
    text << "the slope there, " << params::roundedText(static_cast<double>(slope))
         << ", is above maxSlope = " << conversion.maxSlope;
  else if (freespace::DropWalk(conversion, layers).isEdge(cell.x, cell.y))
    text << "it is the edge of a drop: within 1 m the floor lies lower by more than maxStep = "
         << conversion.maxStep << " m and a voxel";
  else
    text << "the step to a cell beside it is above maxStep = " << conversion.maxStep << " m";
  return text.str();
}

}  // namespace mrpt_mapconv::planning
