#include "BeamVoxels.h"

#include <algorithm>

namespace mrpt_mapconv::voxel
{
namespace
{
/** Puts two zeros between the bits of a key's coordinate. */
std::uint64_t spread(std::uint64_t bits)
{
  bits = (bits | bits << 16) & 0x0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x0c30c30c30c3ULL;
  return (bits | bits << 2) & 0x249249249249ULL;
}

octomap::key_type gather(std::uint64_t code)
{
  code &= 0x249249249249ULL;
  code = (code | code >> 2) & 0x0c30c30c30c3ULL;
  code = (code | code >> 4) & 0x00f00f00f00fULL;
  code = (code | code >> 8) & 0x0000ff0000ffULL;
  return static_cast<octomap::key_type>(code | code >> 16);
}

/** Its bits are, from the highest, the numbers of the children on the way from the root. */
std::uint64_t codeOf(const octomap::OcTreeKey& key)
{
  return spread(key[0]) | spread(key[1]) << 1 | spread(key[2]) << 2;
}

octomap::OcTreeKey keyOf(std::uint64_t code)
{
  return {gather(code), gather(code >> 1), gather(code >> 2)};
}
}  // namespace

BeamVoxels::CodeSet::CodeSet() : m_slots(std::size_t(1) << 16, 0), m_bits(16) {}

std::size_t BeamVoxels::CodeSet::slotOf(std::uint64_t code) const
{
  const std::size_t last = m_slots.size() - 1;
  auto slot = static_cast<std::size_t>(code * 0x9e3779b97f4a7c15ULL >> (64 - m_bits));
  while (m_slots[slot] != 0 && m_slots[slot] != code + 1) slot = (slot + 1) & last;
  return slot;
}

bool BeamVoxels::CodeSet::insert(std::uint64_t code)
{
  std::uint64_t& slot = m_slots[slotOf(code)];
  if (slot != 0) return false;
  slot = code + 1;
  if (++m_size * 2 > m_slots.size()) grow();
  return true;
}

void BeamVoxels::CodeSet::grow()
{
  std::vector<std::uint64_t> old(m_slots.size() * 4, 0);
  old.swap(m_slots);
  m_bits += 2;
  for (const auto held : old)
    if (held != 0) m_slots[slotOf(held - 1)] = held;
}

void BeamVoxels::add(const octomap::OcTreeKey& key, std::vector<std::uint64_t>& codes)
{
  const auto code = codeOf(key);
  if (m_known.insert(code)) codes.push_back(code);
}

BeamVoxels::BeamVoxels(const octomap::OcTree& tree, const octomap::Pointcloud& hits,
                       const octomap::Pointcloud& misses, const octomap::point3d& origin,
                       double maxRange)
{
  const auto isWhole = [&](const octomap::point3d& end)
  { return maxRange < 0 || (end - origin).norm() <= maxRange; };

  octomap::OcTreeKey key;
  for (const auto& end : hits)  // before the free ones, which these win over
    if (isWhole(end) && tree.coordToKeyChecked(end, key)) add(key, m_hit);

  octomap::KeyRay ray;
  for (const auto* ends : {&hits, &misses})
    for (const auto& end : *ends)
    {
      const auto last =
          isWhole(end) ? end : origin + (end - origin).normalized() * static_cast<float>(maxRange);
      if (!tree.computeRayKeys(origin, last, ray)) continue;
      for (const auto& crossed : ray) add(crossed, m_free);
    }
  std::sort(m_free.begin(), m_free.end());
  std::sort(m_hit.begin(), m_hit.end());
}

void BeamVoxels::insertInto(octomap::OcTree& tree, bool lazy) const
{
  for (const auto code : m_free) tree.updateNode(keyOf(code), false, lazy);
  for (const auto code : m_hit) tree.updateNode(keyOf(code), true, lazy);
}

}  // namespace mrpt_mapconv::voxel
