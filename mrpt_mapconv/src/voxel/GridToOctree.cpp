#include "GridToOctree.h"

#include <mrpt_mapconv/voxel/OctreeSource.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "MortonCode.h"

namespace mrpt_mapconv::voxel
{
namespace
{
using Region = VoxelGrid::Table::Region;

/** What a parent has to know of a node. */
struct Node
{
  enum Kind : std::uint8_t
  {
    Missing,
    Leaf,
    Inner
  };
  Kind kind = Missing;
  float value = 0;  //!< log-odds; of an inner node the largest below it
};

/** Nodes of an `.ot` file: a float and a bit for each child. */
struct FullFormat
{
  static constexpr std::size_t kInnerBytes = sizeof(float) + 1, kLeafBytes = kInnerBytes;

  static void put(char* at, float value, std::uint8_t children)
  {
    std::memcpy(at, &value, sizeof(value));
    at[sizeof(value)] = static_cast<char>(children);
  }
  static void putLeaf(char* at, float value) { put(at, value, 0); }
  void putInner(char* at, float value, const std::array<Node, 8>& children) const
  {
    unsigned bits = 0;
    for (unsigned i = 0; i < 8; ++i) bits |= (children[i].kind != Node::Missing ? 1u : 0u) << i;
    put(at, value, static_cast<std::uint8_t>(bits));
  }
};

/** Nodes of a `.bt` file: two bits for each child of an inner node; leaves have none. */
struct BinaryFormat
{
  static constexpr std::size_t kInnerBytes = 2, kLeafBytes = 0;

  static void putLeaf(char*, float) {}
  void putInner(char* at, float, const std::array<Node, 8>& children) const
  {
    unsigned bits = 0;
    for (unsigned i = 0; i < 8; ++i) bits |= bitsOf(children[i]) << (2 * i);
    at[0] = static_cast<char>(bits & 0xFFu);
    at[1] = static_cast<char>(bits >> 8);
  }
  unsigned bitsOf(const Node& node) const
  {
    if (node.kind == Node::Missing) return 0;
    if (node.kind == Node::Inner) return 3;
    return node.value >= occupiedFrom ? 2 : 1;
  }

  float occupiedFrom;
};

/** Writes nodes depth first, a node before its children; what a node says of them is put in when
 * they are known, and if they are all equal they are taken back. */
template <class Format>
class NodeWriter
{
 public:
  NodeWriter(const Format& format, bool pruned) : m_format(format), m_pruned(pruned) {}

  using Part = std::pair<std::uint64_t, const Region*>;  // Morton code of a region, its bricks

  /** \param parts regions of a cube that has 2^levels of them along its side, in Morton order */
  Node writeRegions(const Part* begin, const Part* end, int levels)
  {
    if (begin == end) return {};
    if (levels == 0) return writeBricks(*begin->second, 0, 0, 0, kRegionSide);
    const int shift = 3 * (levels - 1);
    return writeInner(
        [&](unsigned i)
        {
          const auto inChild = [&](const Part& part) { return (part.first >> shift & 7) < i; };
          const Part* const first = std::partition_point(begin, end, inChild);
          const auto upToChild = [&](const Part& part) { return (part.first >> shift & 7) <= i; };
          return writeRegions(first, std::partition_point(first, end, upToChild), levels - 1);
        });
  }

  OctreeNodes take() { return {std::move(m_bytes), m_count}; }

 private:
  Node writeBricks(const Region& region, std::int32_t x, std::int32_t y, std::int32_t z,
                   std::int32_t side)
  {
    if (side == 1)
    {
      const auto& slot = region[static_cast<std::size_t>((x * kRegionSide + y) * kRegionSide + z)];
      if (slot.brick) return writeVoxels<kBrickSide>(slot.brick->logOdds.data());
      return isTouched(slot.value) ? writeEqual(slot.value, kBrickSide) : Node{};
    }
    const std::int32_t half = side / 2;
    return writeInner(
        [&](unsigned i)
        {
          return writeBricks(region, x + (i & 1 ? half : 0), y + (i & 2 ? half : 0),
                             z + (i & 4 ? half : 0), half);
        });
  }

  /** \param voxels the lowest voxel of a cube of side³ voxels within a brick */
  template <std::int32_t side>
  Node writeVoxels(const float* voxels)
  {
    if constexpr (side == 2)
      return writeOctet(voxels);
    else
      return writeInner([&](unsigned i)
                        { return writeVoxels<side / 2>(voxels + offset(i, side / 2)); });
  }

  /** Where child i of a cube in a brick begins, whose sides are so long. */
  static constexpr std::int32_t offset(unsigned i, std::int32_t side)
  {
    return (i & 1 ? side * kBrickColumns : 0) + (i & 2 ? side * kBrickSide : 0) +
           (i & 4 ? side : 0);
  }

  /** The same as writeInner() with eight voxels or fewer, at one go: most nodes are voxels. */
  Node writeOctet(const float* voxels)
  {
    std::array<Node, 8> children;
    std::size_t known = 0;
    bool equal = true;
    float most = std::numeric_limits<float>::lowest();
    for (unsigned i = 0; i < 8; ++i)
    {
      const float value = voxels[offset(i, 1)];
      if (!isTouched(value)) continue;
      children[i] = {Node::Leaf, value};
      ++known;
      equal = equal && value == voxels[0];
      most = std::max(most, value);
    }
    if (known == 0) return {};
    if (known == 8 && equal && m_pruned) return writeLeaf(voxels[0]);
    const std::size_t at = m_bytes.size();
    m_bytes.resize(at + Format::kInnerBytes + known * Format::kLeafBytes);
    char* next = m_bytes.data() + at;
    m_format.putInner(next, most, children);
    next += Format::kInnerBytes;
    for (const Node& child : children)
      if (child.kind == Node::Leaf)
      {
        m_format.putLeaf(next, child.value);
        next += Format::kLeafBytes;
      }
    m_count += 1 + known;
    return {Node::Inner, most};
  }

  /** A cube of equal voxels. */
  Node writeEqual(float value, std::int32_t side)
  {
    if (m_pruned || side == 1) return writeLeaf(value);
    return writeInner([&](unsigned) { return writeEqual(value, side / 2); });
  }

  Node writeLeaf(float value)
  {
    const std::size_t at = m_bytes.size();
    m_bytes.resize(at + Format::kLeafBytes);
    m_format.putLeaf(m_bytes.data() + at, value);
    ++m_count;
    return {Node::Leaf, value};
  }

  template <class WriteChild>
  Node writeInner(const WriteChild& writeChild)
  {
    const std::size_t at = m_bytes.size();
    const std::uint64_t count = m_count;
    m_bytes.resize(at + Format::kInnerBytes);
    ++m_count;
    std::array<Node, 8> children;
    bool any = false, equal = true;
    float most = std::numeric_limits<float>::lowest();
    for (unsigned i = 0; i < 8; ++i)
    {
      const Node child = children[i] = writeChild(i);
      equal = equal && child.kind == Node::Leaf && child.value == children[0].value;
      if (child.kind == Node::Missing) continue;
      any = true;
      most = std::max(most, child.value);
    }
    if (!any || (equal && m_pruned))
    {
      m_bytes.resize(at);
      m_count = count;
      return any ? writeLeaf(children[0].value) : Node{};
    }
    m_format.putInner(m_bytes.data() + at, most, children);
    return {Node::Inner, most};
  }

  Format m_format;
  bool m_pruned;
  std::string m_bytes;
  std::uint64_t m_count = 0;
};

template <class Format>
OctreeNodes nodesOf(const VoxelGrid& grid, const Format& format, bool pruned)
{
  constexpr std::int32_t levels = 16 - kRegionVoxelBits, range = 1 << (levels - 1);
  std::vector<typename NodeWriter<Format>::Part> parts;
  for (const auto& [key, region] : grid.table().regions())
  {
    if (std::all_of(region->begin(), region->end(),
                    [](const auto& slot) { return slot.isUntouched(); }))
      continue;
    for (const std::int32_t k : {key.x, key.y, key.z})
      if (k < -range || k >= range)
        throw std::runtime_error(
            "the voxel map reaches to voxel " +
            std::to_string(static_cast<std::int64_t>(k) * (1 << kRegionVoxelBits)) +
            " on an axis, and an octree holds -32768 to 32767 only; larger voxels or an origin "
            "nearer by would do");
    parts.emplace_back(mortonCode(static_cast<std::uint32_t>(key.x + range),
                                  static_cast<std::uint32_t>(key.y + range),
                                  static_cast<std::uint32_t>(key.z + range)),
                       region.get());
  }
  std::sort(parts.begin(), parts.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  NodeWriter<Format> writer(format, pruned);
  writer.writeRegions(parts.data(), parts.data() + parts.size(), levels);
  return writer.take();
}
}  // namespace

OctreeNodes fullNodes(const VoxelGrid& grid, bool pruned)
{
  return nodesOf(grid, FullFormat{}, pruned);
}

OctreeNodes binaryNodes(const VoxelGrid& grid, bool pruned)
{
  return nodesOf(grid, BinaryFormat{grid.occupiedFrom()}, pruned);
}

}  // namespace mrpt_mapconv::voxel
