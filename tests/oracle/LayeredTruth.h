#pragma once

#include <mrpt_mapconv/sim/Truth.h>

#include <functional>

namespace mrpt_mapconv::oracle
{
/** The slow, obviously right twin of sim::truthLayers() for worlds whose bodies begin and end at
 * multiples of `step` [m]: a vertical line is then fully described by asking for the middle of each
 * such step whether it is solid. All faces are level. */
struct LayeredWorld
{
  std::function<bool(double x, double y, double z)> isSolid;
  mrpt::math::TPoint3D min, max;  //!< bounds [m], z also at multiples of step
  double step = 0.1;
};

freespace::Layers truthOf(const LayeredWorld& world, const grid::GridFrame& frame,
                          const sim::TruthParams& params);
}  // namespace mrpt_mapconv::oracle
