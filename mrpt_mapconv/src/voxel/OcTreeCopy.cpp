#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

#include <istream>
#include <stdexcept>

#include "BytesBuffer.h"
#include "GridToOctree.h"
#include "OctreeToGrid.h"

namespace mrpt_mapconv::voxel
{
namespace
{
/** OctoMap makes a tree's root only together with a voxel. */
class RootedTree : public octomap::OcTree
{
 public:
  explicit RootedTree(double voxelSize) : OcTree(voxelSize)
  {
    root = new octomap::OcTreeNode;  // the tree owns and deletes it
    ++tree_size;
    size_changed = true;
  }
};

template <class From>
void copyNode(const From& from, const typename From::NodeType* source, octomap::OcTree& to,
              octomap::OcTreeNode* target)
{
  target->setLogOdds(source->getLogOdds());
  for (unsigned i = 0; i < 8; ++i)
    if (from.nodeChildExists(source, i))
      copyNode(from, from.getNodeChild(source, i), to, to.createNodeChild(target, i));
}

template <class From>
std::unique_ptr<octomap::OcTree> copyTree(const From& from)
{
  std::unique_ptr<octomap::OcTree> to;
  if (from.getRoot())
    to = std::make_unique<RootedTree>(from.getResolution());
  else
    to = std::make_unique<octomap::OcTree>(from.getResolution());
  to->setOccupancyThres(from.getOccupancyThres());
  to->setProbHit(from.getProbHit());
  to->setProbMiss(from.getProbMiss());
  to->setClampingThresMin(from.getClampingThresMin());
  to->setClampingThresMax(from.getClampingThresMax());
  if (from.getRoot()) copyNode(from, from.getRoot(), *to, to->getRoot());
  return to;
}
}  // namespace

std::unique_ptr<octomap::OcTree> toOcTree(const octomap::AbstractOcTree& tree)
{
  if (const auto* plain = dynamic_cast<const octomap::OcTree*>(&tree))
    return std::make_unique<octomap::OcTree>(*plain);
  if (const auto* color = dynamic_cast<const octomap::ColorOcTree*>(&tree)) return copyTree(*color);
  if (const auto* stamped = dynamic_cast<const octomap::OcTreeStamped*>(&tree))
    return copyTree(*stamped);
  throw std::invalid_argument("octree type '" + tree.getTreeType() + "' holds no occupancy");
}

std::unique_ptr<octomap::OcTree> toOcTree(const VoxelGrid& grid, bool pruned)
{
  auto tree = std::make_unique<octomap::OcTree>(grid.resolution());
  tree->setOccupancyThres(octomap::probability(grid.occupiedFrom()));
  const OctreeNodes nodes = fullNodes(grid, pruned);
  if (nodes.count == 0) return tree;
  BytesBuffer buffer(nodes.bytes);
  std::istream stream(&buffer);
  tree->readData(stream);
  return tree;
}

VoxelGrid toVoxelGrid(const octomap::AbstractOcTree& tree,
                      const std::optional<std::int32_t>& maxMemory)
{
  VoxelGrid grid(tree.getResolution());
  if (const auto* occupancy = dynamic_cast<const octomap::AbstractOccupancyOcTree*>(&tree))
    grid.setOccupiedFrom(occupancy->getOccupancyThresLog());
  addLeaves(tree, maxMemory, grid);
  return grid;
}

}  // namespace mrpt_mapconv::voxel
