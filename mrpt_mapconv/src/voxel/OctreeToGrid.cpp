#include "OctreeToGrid.h"

#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "MemoryLimit.h"

namespace mrpt_mapconv::voxel
{
namespace
{
constexpr std::int32_t kTreeSide = 2 * kOctomapKeyOffset;

/** A node of an `.ot` file; nodes are read one after the other, children in their order. */
class ByteNode
{
 public:
  explicit ByteNode(std::string_view& bytes) : m_bytes(bytes)
  {
    std::memcpy(&m_value, bytes.data(), sizeof(m_value));
    m_children = static_cast<unsigned char>(bytes[sizeof(m_value)]);
    bytes.remove_prefix(sizeof(m_value) + 1);
  }
  float value() const { return m_value; }
  bool hasChildren() const { return m_children != 0; }
  bool hasChild(unsigned i) const { return (m_children >> i & 1u) != 0; }
  ByteNode child(unsigned) const { return ByteNode(m_bytes); }

 private:
  std::string_view& m_bytes;
  float m_value = 0;
  unsigned m_children;
};

template <class Tree>
class TreeNode
{
 public:
  using Node = typename Tree::NodeType;
  TreeNode(const Tree& tree, const Node* node) : m_tree(tree), m_node(node) {}
  float value() const { return m_node->getLogOdds(); }
  bool hasChildren() const { return m_tree.nodeHasChildren(m_node); }
  bool hasChild(unsigned i) const { return m_tree.nodeChildExists(m_node, i); }
  TreeNode child(unsigned i) const { return {m_tree, m_tree.getNodeChild(m_node, i)}; }

 private:
  const Tree& m_tree;
  const Node* m_node;
};

/** A leaf of so many voxels a side takes 4 MB of regions; larger ones are no maps of scans. */
constexpr std::int32_t kLargestLeaf = 1024;

/** Fills a grid with the leaves below a node. */
class GridFiller
{
 public:
  GridFiller(VoxelGrid& grid, const std::optional<std::int32_t>& maxMemory)
      : m_grid(grid), m_maxMemory(maxMemory)
  {
  }

  /** \param at the lowest voxel of the cube of side³ voxels that the node stands for */
  template <class Node>
  void add(const Node& node, const VoxelKey& at, std::int32_t side)
  {
    if (!node.hasChildren()) return fill(at, side, touched(node.value()));
    if (side == kBrickSide) return addToBrick(node, at);
    const std::int32_t half = side / 2;
    for (unsigned i = 0; i < 8; ++i)
      if (node.hasChild(i)) add(node.child(i), childOf(at, half, i), half);
  }

 private:
  static VoxelKey childOf(const VoxelKey& at, std::int32_t half, unsigned i)
  {
    return {at.x + (i & 1 ? half : 0), at.y + (i & 2 ? half : 0), at.z + (i & 4 ? half : 0)};
  }
  /** -0 stands for what was never touched. */
  static float touched(float logOdds) { return logOdds + 0.0f; }

  void fill(const VoxelKey& at, std::int32_t side, float logOdds)
  {
    constexpr std::int32_t regionSide = 1 << kRegionVoxelBits;
    if (side > kLargestLeaf)
      throw LeafTooLarge("an octree with a leaf of " + std::to_string(side) +
                         " voxels a side is too large for blocks; voxelEngine = octomap takes it");
    const std::size_t along = side > regionSide ? static_cast<std::size_t>(side / regionSide) : 1;
    require(along * along * along * VoxelGrid::Table::bytesOfRegion());
    m_grid.fillCube(at, side, logOdds);
  }

  template <class Node>
  void addToBrick(const Node& node, const VoxelKey& at)
  {
    require(sizeof(VoxelGrid::Brick) + VoxelGrid::Table::bytesOfRegion());
    auto& slot = m_grid.table().obtain(regionKey(at))[brickIndex(at)];
    addVoxels(node, slot.expanded().logOdds.data(), kBrickSide);
    slot.collapse();
  }
  template <class Node>
  void addVoxels(const Node& node, float* voxels, std::int32_t side)
  {
    if (!node.hasChildren())
    {
      for (std::int32_t x = 0; x < side; ++x)
        for (std::int32_t y = 0; y < side; ++y)
          std::fill_n(voxels + x * kBrickColumns + y * kBrickSide, side, touched(node.value()));
      return;
    }
    const std::int32_t half = side / 2;
    for (unsigned i = 0; i < 8; ++i)
      if (node.hasChild(i))
        addVoxels(node.child(i),
                  voxels + (i & 1 ? half * kBrickColumns : 0) + (i & 2 ? half * kBrickSide : 0) +
                      (i & 4 ? half : 0),
                  half);
  }

  void require(std::size_t more) { reserveMemory(m_grid, more, m_maxMemory); }

  VoxelGrid& m_grid;
  const std::optional<std::int32_t>& m_maxMemory;
};

constexpr VoxelKey kRoot{-kOctomapKeyOffset, -kOctomapKeyOffset, -kOctomapKeyOffset};

/** \return false for a tree of another type */
template <class Tree>
bool addLeavesAs(const octomap::AbstractOcTree& any, GridFiller& filler)
{
  const auto* tree = dynamic_cast<const Tree*>(&any);
  if (!tree) return false;
  if (tree->getRoot()) filler.add(TreeNode<Tree>(*tree, tree->getRoot()), kRoot, kTreeSide);
  return true;
}
}  // namespace

void addFullNodes(std::string_view bytes, const std::optional<std::int32_t>& maxMemory,
                  VoxelGrid& grid)
{
  if (bytes.empty()) return;
  const ByteNode root(bytes);
  GridFiller(grid, maxMemory).add(root, kRoot, kTreeSide);
}

void addLeaves(const octomap::AbstractOcTree& tree, const std::optional<std::int32_t>& maxMemory,
               VoxelGrid& grid)
{
  GridFiller filler(grid, maxMemory);
  if (!addLeavesAs<octomap::OcTree>(tree, filler) &&
      !addLeavesAs<octomap::ColorOcTree>(tree, filler) &&
      !addLeavesAs<octomap::OcTreeStamped>(tree, filler))
    throw std::invalid_argument("octree type '" + tree.getTreeType() + "' holds no occupancy");
}

}  // namespace mrpt_mapconv::voxel
