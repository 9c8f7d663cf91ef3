#include "../CurvedBody.h"
#include "../SectionKeys.h"
#include "../UprightCylinder.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** An upright cylinder. base: centre of its lower face, x y z [m]; radius, height [m]. */
std::unique_ptr<Primitive> read(params::StrictSection& section)
{
  const auto base = readPoint3D(section, "base");
  const double radius = readPositive(section, "radius");
  return std::make_unique<CurvedBody<UprightCylinder>>(
      UprightCylinder(base, radius, readPositive(section, "height")));
}

const PrimitiveKind kKind("cylinder", read);
}  // namespace
}  // namespace mrpt_mapconv::sim
