#pragma once

#include <mrpt_mapconv/sim/Primitive.h>

#include <memory>

namespace mrpt_mapconv::sim
{
/** How a trunk grows. */
struct TrunkShape
{
  double radius = 0, topRadius = 0;  //!< [m], > 0
  double height = 0;                 //!< above the ground at its middle [m], > 0
};

/** An upright trunk that goes down to the lowest ground around its foot; there must be some.
 * \param foot its middle on the ground [m] */
std::unique_ptr<Primitive> trunkAt(const World& world, const mrpt::math::TPoint3D& foot,
                                   const TrunkShape& shape);

/** A log that touches the ground at both of its ends.
 * \param from,to ends, on the ground [m]; not above each other */
std::unique_ptr<Primitive> logBetween(const mrpt::math::TPoint3D& from,
                                      const mrpt::math::TPoint3D& to, double radius);

}  // namespace mrpt_mapconv::sim
