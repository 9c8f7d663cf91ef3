#include "../OnGround.h"
#include "../Timber.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** A lying trunk. from, to: its ends, x y [m]; radius [m]. */
Bodies readLog(params::StrictSection& section, const World& world)
{
  const auto from = readFoot(section, "from", world), to = readFoot(section, "to", world);
  if (from.x == to.x && from.y == to.y) section.fail("to", "another place than from");
  Bodies bodies;
  bodies.push_back(logBetween(from, to, readPositive(section, "radius")));
  return bodies;
}

const PrimitiveKind kKind("log", readLog);
}  // namespace
}  // namespace mrpt_mapconv::sim
