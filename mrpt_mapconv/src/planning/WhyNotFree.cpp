#include "WhyNotFree.h"

#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/params/Text.h>

#include <cmath>
#include <sstream>

namespace mrpt_mapconv::planning
{
std::string whyNotFree(const freespace::Layers& layers,
                       const freespace::ConversionParams& conversion, freespace::Robot robot,
                       Cell cell)
{
  const bool ground = robot == freespace::Robot::Ground;
  const float aerial = layers.aerial.at(cell.x, cell.y);
  if (grid::isFree(ground ? layers.ground.at(cell.x, cell.y) : aerial)) return {};
  std::ostringstream text;
  if (!grid::isFree(aerial))
    text << (grid::isOccupied(aerial) ? "no free range there is"
                                      : "no free range is known there that is")
         << " minClearance = " << conversion.minClearance << " m high";
  else if (const float slope = layers.slope.at(cell.x, cell.y); std::isnan(slope))
    text << "the slope there is not known";
  else if (static_cast<double>(slope) > conversion.maxSlope || !conversion.looksForSteps())
    text << "the slope there, " << params::roundedText(static_cast<double>(slope))
         << ", is above maxSlope = " << conversion.maxSlope;
  else
    text << "the step to a cell beside it is above maxStep = "
         << params::roundedText(conversion.stepHeight(layers.frame().resolution)) << " m";
  return text.str();
}

}  // namespace mrpt_mapconv::planning
