#include <mrpt_mapconv/voxel/LeafProbabilities.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

namespace mrpt_mapconv::voxel
{
namespace
{
template <class Tree>
bool holdsAny(const octomap::AbstractOcTree& any)
{
  const auto* tree = dynamic_cast<const Tree*>(&any);
  if (!tree) return false;
  const float lowest = tree->getClampingThresMinLog(), highest = tree->getClampingThresMaxLog();
  for (auto leaf = tree->begin_leafs(), end = tree->end_leafs(); leaf != end; ++leaf)
    if (leaf->getLogOdds() != lowest && leaf->getLogOdds() != highest) return true;
  return false;
}
}  // namespace

bool holdsProbabilities(const octomap::AbstractOcTree& tree)
{
  return holdsAny<octomap::OcTree>(tree) || holdsAny<octomap::ColorOcTree>(tree) ||
         holdsAny<octomap::OcTreeStamped>(tree);
}

}  // namespace mrpt_mapconv::voxel
