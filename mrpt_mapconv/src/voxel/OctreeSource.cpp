#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace mrpt_mapconv::voxel
{
namespace
{
constexpr std::int32_t kTreeSide = 65536;  // voxels along the root node's side

/** The children of a node, read from it once: OctoMap's own accessors test for the array of
 * children anew at every call, which is a good part of the time of a walk over the leaves. */
template <class Node>
class Children : private Node
{
 public:
  explicit Children(const Node* node) : m_array(node->*(&Children::children)) {}
  /** Whether there may be any; an array without a child is possible. */
  explicit operator bool() const { return m_array != nullptr; }
  /** Child i, or null. */
  const Node* operator[](unsigned i) const { return static_cast<const Node*>(m_array[i]); }
  bool any() const
  {
    if (m_array)
      for (unsigned i = 0; i < 8; ++i)
        if (m_array[i]) return true;
    return false;
  }

 private:
  octomap::AbstractOcTreeNode* const* m_array;
};

/** Finds the bounding box of all columns with a leaf, in OctoMap's unsigned keys. A node inside the
 * box found so far adds nothing and is not entered, so only the map's rim is visited. */
template <class Node>
class BoundsSearch
{
 public:
  void visit(const Node* node, std::int32_t x, std::int32_t y, std::int32_t size)
  {
    const std::int32_t xLast = x + size - 1, yLast = y + size - 1;
    if (x >= m_box.xMin && y >= m_box.yMin && xLast <= m_box.xMax && yLast <= m_box.yMax) return;
    const Children<Node> children(node);
    if (size == 1 || !children.any())
    {
      m_box = {std::min(m_box.xMin, x), std::min(m_box.yMin, y), std::max(m_box.xMax, xLast),
               std::max(m_box.yMax, yLast)};
      return;
    }
    const std::int32_t half = size / 2;
    // opposite corners first: they widen the box soonest
    for (const unsigned i : {0u, 7u, 3u, 4u, 5u, 2u, 1u, 6u})
      if (const Node* child = children[i])
        visit(child, x + (i & 1 ? half : 0), y + (i & 2 ? half : 0), half);
  }
  const KeyRect& box() const { return m_box; }

 private:
  KeyRect m_box{kTreeSide, kTreeSide, -1, -1};
};

/** The highest OctoMap z key of the leaves below a node whose lowest voxel is z; `best` if none is
 * higher. What could not be higher is not entered. */
template <class Node>
std::int32_t highestKey(const Node* node, std::int32_t z, std::int32_t size, std::int32_t best)
{
  const std::int32_t last = z + size - 1;
  if (last <= best) return best;
  const Children<Node> children(node);
  if (size == 1 || !children.any()) return last;
  const std::int32_t half = size / 2;
  for (const unsigned i : {4u, 5u, 6u, 7u, 0u, 1u, 2u, 3u})
    if (const Node* child = children[i])
      best = highestKey(child, z + (i & 4 ? half : 0), half, best);
  return best;
}

/** A node that lies within a block's columns, or covers them all. */
template <class Node>
struct StackedNode
{
  const Node* node;
  std::int32_t z;     // OctoMap key of its lowest voxel
  std::int32_t size;  // its side in voxels
};

/** Collects from below `node`, whose lowest voxel is z, what the block's columns at OctoMap keys
 * (x, y) hold, from the lowest up: the nodes of the block's own size and leaves that are larger. */
template <class Node>
void collectStack(const Node* node, std::int32_t x, std::int32_t y, std::int32_t z,
                  std::int32_t size, std::vector<StackedNode<Node>>& out)
{
  const Children<Node> children(node);
  if (size == kBlockSide || !children.any())
  {
    out.push_back({node, z, size});
    return;
  }
  const std::int32_t half = size / 2;
  const unsigned column = (x & half ? 1u : 0u) + (y & half ? 2u : 0u);
  for (unsigned up = 0; up < 2; ++up)
    if (const Node* child = children[column + 4 * up])
      collectStack(child, x, y, z + (up ? half : 0), half, out);
}

/** Marks the leaves below a node of the block's size.
 * \tparam all whether all columns are wanted; known beforehand, the test for it costs nothing */
template <class Tree, bool all>
class BlockMarker
{
 public:
  using Node = typename Tree::NodeType;

  BlockMarker(const Tree& tree, ColumnBlock& block)
      : m_block(block), m_occupiedFrom(tree.getOccupancyThresLog())
  {
    m_missing.setLogOdds(-std::numeric_limits<float>::infinity());
  }

  /** The cube of `size`³ voxels with its lowest corner at column (x, y), signed z key z. */
  template <std::int32_t size>
  void mark(const Node* node, std::int32_t x, std::int32_t y, std::int32_t z)
  {
    constexpr std::int32_t half = size / 2;
    bool leaf = true;
    if (const Children<Node> children(node); children)
    {
      const unsigned due = wantedChildren<half>(x, y);
      if constexpr (size == 2)
        leaf = !markOctet(children, due, x, y, z);
      else
      {
        if constexpr (!all) fetch(children, due);
        for (unsigned i = 0; i < 8; ++i)
        {
          const Node* child = children[i];
          if (!child) continue;
          leaf = false;
          if (due >> i & 1u)
            mark<half>(child, x + (i & 1 ? half : 0), y + (i & 2 ? half : 0),
                       z + (i & 4 ? half : 0));
        }
      }
    }
    if (leaf) m_block.markCube<size>(x, y, z, isOccupied(node));
  }

 private:
  /** As Tree::isNodeOccupied, with the threshold at hand. */
  bool isOccupied(const Node* node) const { return node->getLogOdds() >= m_occupiedFrom; }

  /** Lets the memory look for the children at the same time. For scattered columns their nodes are
   * rarely in a cache; a walk over all the leaves finds most of them there and would only pay. */
  static void fetch(const Children<Node>& children, unsigned due)
  {
    for (unsigned i = 0; i < 8; ++i)
      if (due >> i & 1u) __builtin_prefetch(children[i]);
  }

  /** Marks the finest voxels below a node, as far as they are due; false if there is none. */
  bool markOctet(const Children<Node>& children, unsigned due, std::int32_t x, std::int32_t y,
                 std::int32_t z)
  {
    // No branches: at the rim of what is known it is chance which voxels exist, and a wrongly
    // foreseen branch costs more than looking at a stand-in for a missing voxel.
    unsigned known = 0, occupied = 0;
    for (unsigned i = 0; i < 8; ++i)
    {
      const Node* child = children[i];
      known |= static_cast<unsigned>(child != nullptr) << i;
      occupied |= static_cast<unsigned>(isOccupied(child && due >> i & 1u ? child : &m_missing))
                  << i;
    }
    if (!known) return false;
    const unsigned marked = known & due;
    m_block.markOctet(x, y, z, marked & ~occupied, marked & occupied);
    return true;
  }

  /** Which of the 8 children of `size`³ voxels, the lowest at (x, y), have wanted columns. */
  template <std::int32_t size>
  unsigned wantedChildren(std::int32_t x, std::int32_t y) const
  {
    if constexpr (all) return 0xFFu;
    const auto inRows = [&](std::int32_t begin)
    {
      std::uint32_t any = 0;
      for (std::int32_t row = begin; row < begin + size; ++row)
        any |= m_block.wanted()[static_cast<std::size_t>(row)];
      constexpr std::uint32_t side = (1u << size) - 1;
      return static_cast<unsigned>((any >> x & side) != 0) |
             static_cast<unsigned>((any >> (x + size) & side) != 0) << 1;
    };
    return 0x11u * (inRows(y) | inRows(y + size) << 2);
  }

  ColumnBlock& m_block;
  float m_occupiedFrom;  // log-odds
  Node m_missing;        // stands for a voxel that does not exist; not occupied
};

template <bool all, class Tree>
void markStack(const Tree& tree, const std::vector<StackedNode<typename Tree::NodeType>>& stack,
               ColumnBlock& block)
{
  BlockMarker<Tree, all> marker(tree, block);
  for (const auto& [node, key, size] : stack)
  {
    const std::int32_t z = key - kOctomapKeyOffset;
    if (size == kBlockSide)
      marker.template mark<kBlockSide>(node, 0, 0, z);
    else
      block.markSlab(z, z + size, tree.isNodeOccupied(node));
  }
}
}  // namespace

template <class Tree>
double OctreeSource<Tree>::resolution() const
{
  return m_tree.getResolution();
}

template <class Tree>
std::optional<KeyRect> OctreeSource<Tree>::bounds() const
{
  if (!m_tree.getRoot()) return std::nullopt;
  BoundsSearch<typename Tree::NodeType> search;
  search.visit(m_tree.getRoot(), 0, 0, kTreeSide);
  const KeyRect& box = search.box();
  return KeyRect{box.xMin - kOctomapKeyOffset, box.yMin - kOctomapKeyOffset,
                 box.xMax - kOctomapKeyOffset, box.yMax - kOctomapKeyOffset};
}

template <class Tree>
std::optional<std::int32_t> OctreeSource<Tree>::top() const
{
  if (!m_tree.getRoot()) return std::nullopt;
  return highestKey<typename Tree::NodeType>(m_tree.getRoot(), 0, kTreeSide, -1) -
         kOctomapKeyOffset;
}

template <class Tree>
void OctreeSource<Tree>::read(ColumnBlock& block) const
{
  if (!m_tree.getRoot()) return;
  const std::int32_t x = block.key().x * kBlockSide + kOctomapKeyOffset;
  const std::int32_t y = block.key().y * kBlockSide + kOctomapKeyOffset;
  if (x < 0 || y < 0 || x >= kTreeSide || y >= kTreeSide) return;

  std::vector<StackedNode<typename Tree::NodeType>> stack;  // in ascending order of z
  collectStack<typename Tree::NodeType>(m_tree.getRoot(), x, y, 0, kTreeSide, stack);
  if (stack.empty()) return;

  block.setHeight(stack.front().z - kOctomapKeyOffset,
                  stack.back().z + stack.back().size - kOctomapKeyOffset);
  const auto& wanted = block.wanted();
  if (std::all_of(wanted.begin(), wanted.end(), [](auto row) { return row == kFullRow; }))
    markStack<true>(m_tree, stack, block);
  else
    markStack<false>(m_tree, stack, block);
}

template class OctreeSource<octomap::OcTree>;
template class OctreeSource<octomap::ColorOcTree>;
template class OctreeSource<octomap::OcTreeStamped>;

std::unique_ptr<VoxelSource> makeOctreeSource(const octomap::AbstractOcTree& tree)
{
  if (const auto* plain = dynamic_cast<const octomap::OcTree*>(&tree))
    return std::make_unique<OctreeSource<octomap::OcTree>>(*plain);
  if (const auto* color = dynamic_cast<const octomap::ColorOcTree*>(&tree))
    return std::make_unique<OctreeSource<octomap::ColorOcTree>>(*color);
  if (const auto* stamped = dynamic_cast<const octomap::OcTreeStamped*>(&tree))
    return std::make_unique<OctreeSource<octomap::OcTreeStamped>>(*stamped);
  throw std::invalid_argument("octree type '" + tree.getTreeType() +
                              "' holds no occupancy; OcTree, ColorOcTree or OcTreeStamped would");
}

}  // namespace mrpt_mapconv::voxel
