#pragma once

#include <mrpt_mapconv/sim/RayCaster.h>

#include "Random.h"

namespace mrpt_mapconv::sim
{
/** What a sensor's ray comes back from. */
struct Echo
{
  float range = 0;              //!< length of the ray's way [m]
  std::int32_t body = -1;       //!< its number in the world; −1: the ray does not come back
  mrpt::math::TPoint3Df place;  //!< [m]
  bool mirrored = false;        //!< the way is folded
};

/** Follows a ray through glass and over mirrors, see Sensor, to the surface that returns it; its
 * way may be `maxRange` long [m]. */
Echo echoOf(const RayCaster& caster, const Ray& ray, float maxRange, Random random);

}  // namespace mrpt_mapconv::sim
