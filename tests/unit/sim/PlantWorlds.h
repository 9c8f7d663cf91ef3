#pragma once

#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/World.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mrpt_mapconv::test
{
/** Flat ground at z = 1, and a slope of 0.5 towards +x that is 1 at x = 0. @{ */
inline const std::string kFlat =
    "[heightField.g]\nmin = -20 -20\nmax = 20 20\ncell = 1\nsolid = below\nbase = 1\n";
inline const std::string kSlope =
    "[heightField.g]\nmin = -10 -10\nmax = 10 10\ncell = 0.5\nsolid = below\nbase = 1\n"
    "gradient = 0.5 0\n";
/** @} */

/** 4 m of leaves over (2, 3), from z = 6 on. */
inline const std::string kCrown =
    "[canopy.a]\nplace = 2 3\nbottom = 5\ntop = 9\nradius = 5\ndensity = 0.4\n";

/** Solids of what is not the ground. */
inline std::vector<sim::Solid> plantsAt(const sim::World& world, double x, double y)
{
  std::vector<sim::Solid> solids;
  for (std::size_t i = 0; i < world.size(); ++i)
    if (!world.primitive(i).isGround()) world.primitive(i).appendSolids(x, y, solids);
  return solids;
}

/** A ray from above, or from elsewhere to a place. */
inline sim::Ray rayTo(const mrpt::math::TPoint3D& from, const mrpt::math::TPoint3D& to,
                      std::uint64_t key = 0)
{
  mrpt::math::TPoint3D d = to - from;
  d *= 1 / d.norm();
  return {mrpt::math::TPoint3Df(from), mrpt::math::TPoint3Df(d), key};
}

}  // namespace mrpt_mapconv::test
