#include <mrpt/maps/CColouredOctoMap.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

#include <stdexcept>

// MRPT declares this struct in its public header but defines it in a private one, which Debian does
// not ship; without a definition getOctomap() cannot compile. These repeat its only member.
namespace mrpt::maps
{
template <>
struct COctoMapBase<octomap::OcTree, octomap::OcTreeNode>::Impl
{
  octomap::OcTree m_octomap;
};
template <>
struct COctoMapBase<octomap::ColorOcTree, octomap::ColorOcTreeNode>::Impl
{
  octomap::ColorOcTree m_octomap;
};
}  // namespace mrpt::maps

namespace mrpt_mapconv::maps
{
namespace
{
/** MRPT offers no const access; nothing is changed through it here. */
template <class Tree, class Map>
const Tree& octreeInside(const Map& map)
{
  struct Access : Map
  {
    static const Tree& of(const Map& m) { return (m.*(&Access::m_impl))->m_octomap; }
  };
  return Access::of(map);
}

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

const octomap::OcTree& octreeOf(const mrpt::maps::COctoMap& map)
{
  return octreeInside<octomap::OcTree>(map);
}

const octomap::ColorOcTree& octreeOf(const mrpt::maps::CColouredOctoMap& map)
{
  return octreeInside<octomap::ColorOcTree>(map);
}

const octomap::AbstractOcTree* octreeIn(const mrpt::serialization::CSerializable& object)
{
  if (const auto* plain = dynamic_cast<const mrpt::maps::COctoMap*>(&object))
    return &octreeOf(*plain);
  if (const auto* color = dynamic_cast<const mrpt::maps::CColouredOctoMap*>(&object))
    return &octreeOf(*color);
  if (const auto* ours = dynamic_cast<const CFreeSpaceGridMap2D*>(&object)) return &ours->octree();
  if (const auto* several = dynamic_cast<const mrpt::maps::CMultiMetricMap*>(&object))
    for (const auto& map : several->maps)
      if (const auto* tree = map ? octreeIn(*map) : nullptr) return tree;
  return nullptr;
}

std::unique_ptr<octomap::OcTree> toOcTree(const octomap::AbstractOcTree& tree)
{
  if (const auto* plain = dynamic_cast<const octomap::OcTree*>(&tree))
    return std::make_unique<octomap::OcTree>(*plain);
  if (const auto* color = dynamic_cast<const octomap::ColorOcTree*>(&tree)) return copyTree(*color);
  if (const auto* stamped = dynamic_cast<const octomap::OcTreeStamped*>(&tree))
    return copyTree(*stamped);
  throw std::invalid_argument("octree type '" + tree.getTreeType() + "' holds no occupancy");
}

}  // namespace mrpt_mapconv::maps
