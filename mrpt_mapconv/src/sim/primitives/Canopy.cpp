#include "../Crown.h"
#include "../OnGround.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** The crown of a tree. place: of its middle, x y [m]; bottom, top: above the ground there [m];
 * radius [m]; density, solid: see Leaves. */
Bodies readCanopy(params::StrictSection& section, const World& world)
{
  CrownShape shape;
  shape.bottom = readNumber(section, "bottom");
  shape.top = readNumber(section, "top");
  if (!(shape.bottom < shape.top)) section.fail("top", "above bottom");
  shape.radius = readPositive(section, "radius");
  const Leaves leaves = Leaves::read(section);
  Bodies bodies;
  bodies.push_back(crownOver(readFoot(section, "place", world), shape, leaves));
  return bodies;
}

const PrimitiveKind kKind("canopy", readCanopy);
}  // namespace
}  // namespace mrpt_mapconv::sim
