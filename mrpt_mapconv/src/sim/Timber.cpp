#include "Timber.h"

#include <mrpt_mapconv/sim/World.h>

#include <algorithm>
#include <cmath>

#include "CurvedBody.h"
#include "TaperedCylinder.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3D;

std::unique_ptr<Primitive> trunkAt(const World& world, const TPoint3D& foot,
                                   const TrunkShape& shape)
{
  constexpr int kAround = 8;
  constexpr double kTurn = 2 * 3.14159265358979323846;
  TPoint3D root = foot;
  for (int i = 0; i < kAround; ++i)
  {
    const double x = foot.x + shape.radius * std::cos(kTurn * i / kAround);
    const double y = foot.y + shape.radius * std::sin(kTurn * i / kAround);
    root.z = std::min(root.z, world.groundAt(x, y).value_or(foot.z));
  }
  const TPoint3D top(foot.x, foot.y, foot.z + shape.height);
  return std::make_unique<CurvedBody<TaperedCylinder>>(
      TaperedCylinder({root, shape.radius}, {top, shape.topRadius}));
}

std::unique_ptr<Primitive> logBetween(const TPoint3D& from, const TPoint3D& to, double radius)
{
  const TPoint3D up(0, 0, radius);
  return std::make_unique<CurvedBody<TaperedCylinder>>(
      TaperedCylinder({from + up, radius}, {to + up, radius}));
}

}  // namespace mrpt_mapconv::sim
