#include "../OnGround.h"
#include "../Timber.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** An upright trunk. place: of its middle, x y [m]; radius at the ground, height [m]; topRadius:
 * default radius. */
Bodies readTrunk(params::StrictSection& section, const World& world)
{
  TrunkShape shape;
  shape.radius = readPositive(section, "radius");
  shape.topRadius = readPositive(section, "topRadius", shape.radius);
  shape.height = readPositive(section, "height");
  Bodies bodies;
  bodies.push_back(trunkAt(world, readFoot(section, "place", world), shape));
  return bodies;
}

const PrimitiveKind kKind("trunk", readTrunk);
}  // namespace
}  // namespace mrpt_mapconv::sim
