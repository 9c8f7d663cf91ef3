#pragma once

#include <mrpt_mapconv/path/StepLimit.h>

#include "GridSearch.h"

namespace mrpt_mapconv::planning
{
/** Tells a ground robot's search where the floor is too uneven.
 *
 * Between cells beside each other whose floors differ by more than StepLimit nothing goes. Where
 * two that meet at a corner do, a straight segment is looked at point by point, as liftPath() sets
 * them. So on no way that the search finds the floors below neighbouring points differ by more than
 * StepLimit allows.
 *
 * \param floor on which the robot stands, on the search's frame [m]; it must outlive the search */
void blockFloorSteps(const grid::Layer<float>& floor, const path::StepLimit& limit,
                     GridSearch& search);

}  // namespace mrpt_mapconv::planning
