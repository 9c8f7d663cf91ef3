#include "BeamVoxels.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "MortonCode.h"

namespace mrpt_mapconv::voxel
{
namespace
{
/** Its bits are, from the highest, the numbers of the children on the way from the root. */
std::uint64_t codeOf(const octomap::OcTreeKey& key) { return mortonCode(key[0], key[1], key[2]); }

octomap::OcTreeKey keyOf(std::uint64_t code)
{
  const auto key = [code](int axis)
  { return static_cast<octomap::key_type>(gatherBits(code >> axis)); };
  return {key(0), key(1), key(2)};
}
/** Whether keys are those of neighbours. Where rounding errors take a beam out of the tree's range,
 * OctoMap goes on at the other end of it. */
bool areNeighbours(const octomap::OcTreeKey& a, const octomap::OcTreeKey& b)
{
  for (unsigned i = 0; i < 3; ++i)
    if (std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i])) > 1) return false;
  return true;
}

/** computeRayKeys() writes past the end of its list if a beam has more voxels. */
void requireRoom(const octomap::KeyRay& ray, const VoxelKey& from, const VoxelKey& to)
{
  const int steps = std::abs(to.x - from.x) + std::abs(to.y - from.y) + std::abs(to.z - from.z);
  constexpr int kMore = 8;  // by rounding errors
  const auto most = static_cast<int>(ray.sizeMax()) - kMore;
  if (steps < most) return;
  throw std::runtime_error("a beam goes through " + std::to_string(steps) +
                           " voxels, but voxelEngine = octomap takes less than " +
                           std::to_string(most) +
                           " only; blocks, larger voxels or a smaller maxrange would do");
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

BeamVoxels::BeamVoxels(const octomap::OcTree& tree, const ScanBeams& beams)
{
  const auto octomapKey = [](const VoxelKey& key)
  {
    const auto shifted = [](std::int32_t k)
    { return static_cast<octomap::key_type>(k + kOctomapKeyOffset); };
    return octomap::OcTreeKey(shifted(key.x), shifted(key.y), shifted(key.z));
  };
  for (const auto& beam : beams.hits) add(octomapKey(beam.key), m_hit);  // these win over free ones
  octomap::KeyRay ray;
  for (const auto* ends : {&beams.hits, &beams.misses})
    for (const auto& beam : *ends)
    {
      requireRoom(ray, beams.originKey, beam.key);
      if (!tree.computeRayKeys(beams.origin, beam.end, ray)) continue;
      for (auto crossed = ray.begin(); crossed != ray.end(); ++crossed)
      {
        if (crossed != ray.begin() && !areNeighbours(*(crossed - 1), *crossed)) break;
        add(*crossed, m_free);
      }
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
