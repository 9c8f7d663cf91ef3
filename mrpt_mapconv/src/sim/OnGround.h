#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/sim/World.h>

#include "SectionKeys.h"

namespace mrpt_mapconv::sim
{
/** The place x y that a key names, with the ground's height there [m].
 * \exception std::runtime_error naming section, key and value if there is no ground */
inline mrpt::math::TPoint3D readFoot(params::StrictSection& section, const std::string& key,
                                     const World& world)
{
  const auto place = readPoint2D(section, key);
  const auto ground = world.groundAt(place.x, place.y);
  if (!ground) section.fail(key, "a place with ground (of a heightField) at it");
  return {place.x, place.y, *ground};
}

}  // namespace mrpt_mapconv::sim
