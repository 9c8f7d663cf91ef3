#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/freespace/Robot.h>

#include <string>

#include "PassableCells.h"

namespace mrpt_mapconv::planning
{
/** Why a cell is not free for a robot, in words that name the parameter that decided; empty if it
 * is free.
 * \param cell on the layers, which were made with `conversion` */
std::string whyNotFree(const freespace::Layers& layers,
                       const freespace::ConversionParams& conversion, freespace::Robot robot,
                       Cell cell);

}  // namespace mrpt_mapconv::planning
