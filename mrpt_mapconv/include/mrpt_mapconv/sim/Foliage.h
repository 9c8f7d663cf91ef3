#pragma once

#include <mrpt/math/TPoint3D.h>

#include <array>
#include <cstddef>
#include <optional>

namespace mrpt_mapconv::sim
{
/** The part of a line that lies inside something: lengths from the line's origin on [m]. */
struct Stretch
{
  double from = 0, to = 0;
};

/** Leaves, evenly scattered in convex parts: a ray ends on one of them or goes through, which
 * exp(-density * way) of all rays do (Beer and Lambert). Which do depends on the ray's key alone.
 */
class Foliage
{
 public:
  virtual ~Foliage() = default;
  virtual std::size_t parts() const = 0;
  /** Lower and upper corner of a box around a part [m]. */
  virtual std::array<mrpt::math::TPoint3D, 2> boundsOf(std::size_t part) const = 0;
  /** \param direction of length 1 */
  virtual std::optional<Stretch> inside(std::size_t part, const mrpt::math::TPoint3D& origin,
                                        const mrpt::math::TVector3D& direction) const = 0;
  /** Leaves that a ray meets on a metre, in the mean [1/m]; > 0. */
  virtual double density() const = 0;
};

}  // namespace mrpt_mapconv::sim
