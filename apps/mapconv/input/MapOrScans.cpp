#include "input/MapOrScans.h"

#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <octomap/AbstractOcTree.h>

#include <stdexcept>

namespace mapconv
{
using namespace mrpt_mapconv;

MapOrScans findMapOrScans(files::ObjectFile& file)
{
  std::string others;
  for (auto object = file.peek(); object; file.next(), object = file.peek())
  {
    if (const auto kind = logKindOf(*object)) return {kind, object};
    const std::string name = object->GetRuntimeClass()->className;
    if (const auto* tree = maps::octreeIn(*object))
    {
      if (tree->size() == 0)
        throw std::runtime_error(file.path() + ": the octomap in its " + name +
                                 " is empty: not one voxel is known");
      return {{}, object, tree, name + " (" + tree->getTreeType() + ")"};
    }
    others += (others.empty() ? "a " : ", a ") + name;
  }
  throw std::runtime_error(file.path() + ": holds no octomap and no scans, but " +
                           (others.empty() ? "no object at all" : others));
}

}  // namespace mapconv
