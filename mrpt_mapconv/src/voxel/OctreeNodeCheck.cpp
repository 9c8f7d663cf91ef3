#include "OctreeNodeCheck.h"

#include <bitset>
#include <cmath>
#include <cstring>

namespace mrpt_mapconv::voxel
{
namespace
{
/** Levels below the root of every OctoMap tree; it bounds the recursions here. */
constexpr int kDepth = 16;
constexpr const char* kTruncated = "the data end there";
constexpr const char* kTooDeep = "it has children below the tree's 16 levels";
constexpr const char* kChildless = "it is an inner node without any child";
constexpr const char* kNotFinite = "its occupancy is not a finite number";

std::uint64_t countBits(unsigned bits) { return std::bitset<16>(bits).count(); }

class BinaryWalk
{
 public:
  explicit BinaryWalk(std::string_view bytes) : m_bytes(bytes) { m_check.nodes = 1; }

  /** The inner node at the present position and all below it. \return false after a fault */
  bool walk(int depth)
  {
    if (m_bytes.size() - m_check.bytes < 2) return fail(kTruncated);
    const unsigned bits = byteAt(m_check.bytes) | byteAt(m_check.bytes + 1) << 8;
    const unsigned known = (bits | bits >> 1) & 0x5555u;
    const unsigned inner = bits & bits >> 1 & 0x5555u;
    // Only the root may be a leaf: OctoMap would take any other node without children as free.
    if (known == 0 && depth > 0) return fail(kChildless);
    if (inner != 0 && depth + 1 >= kDepth) return fail(kTooDeep);
    m_check.nodes += countBits(known);
    m_check.bytes += 2;
    for (auto left = countBits(inner); left > 0; --left)
      if (!walk(depth + 1)) return false;
    return true;
  }

  const NodeCheck& check() const { return m_check; }

 private:
  unsigned byteAt(std::size_t i) const { return static_cast<unsigned char>(m_bytes[i]); }
  bool fail(const char* fault)
  {
    m_check.fault = fault;
    return false;
  }

  std::string_view m_bytes;
  NodeCheck m_check;
};

class FullWalk
{
 public:
  FullWalk(std::string_view bytes, std::size_t extraBytes)
      : m_bytes(bytes), m_nodeBytes(sizeof(float) + extraBytes + 1)
  {
  }

  /** The node at the present position and all below it. \return false after a fault */
  bool walk(int depth)
  {
    if (m_bytes.size() - m_check.bytes < m_nodeBytes) return fail(kTruncated);
    float value = 0;
    std::memcpy(&value, m_bytes.data() + m_check.bytes, sizeof(value));
    if (!std::isfinite(value)) return fail(kNotFinite);
    const unsigned children = static_cast<unsigned char>(m_bytes[m_check.bytes + m_nodeBytes - 1]);
    if (children != 0 && depth >= kDepth) return fail(kTooDeep);
    ++m_check.nodes;
    m_check.bytes += m_nodeBytes;
    for (auto left = countBits(children); left > 0; --left)
      if (!walk(depth + 1)) return false;
    return true;
  }

  const NodeCheck& check() const { return m_check; }

 private:
  bool fail(const char* fault)
  {
    m_check.fault = fault;
    return false;
  }

  std::string_view m_bytes;
  std::size_t m_nodeBytes;
  NodeCheck m_check;
};
}  // namespace

NodeCheck checkBinaryNodes(std::string_view bytes)
{
  BinaryWalk walk(bytes);
  walk.walk(0);
  return walk.check();
}

NodeCheck checkFullNodes(std::string_view bytes, std::size_t extraBytes)
{
  FullWalk walk(bytes, extraBytes);
  walk.walk(0);
  return walk.check();
}

}  // namespace mrpt_mapconv::voxel
