#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>

namespace mrpt_mapconv::voxel
{
/** A voxel's signed keys: it covers [k·resolution, (k+1)·resolution) on each axis. */
struct VoxelKey
{
  std::int32_t x = 0, y = 0, z = 0;
  bool operator==(const VoxelKey& o) const { return x == o.x && y == o.y && z == o.z; }
  bool operator!=(const VoxelKey& o) const { return !(*this == o); }
};

struct VoxelKeyHash
{
  std::size_t operator()(const VoxelKey& k) const
  {
    const auto mix = [](std::int32_t key, std::uint64_t by)
    { return static_cast<std::uint32_t>(key) * by; };
    const std::uint64_t sum = mix(k.x, 0x9E3779B97F4A7C15u) ^ mix(k.y, 0xC2B2AE3D27D4EB4Fu) ^
                              mix(k.z, 0x165667B19E3779F9u);
    return static_cast<std::size_t>(sum ^ sum >> 32);
  }
};

/** Voxels are kept in bricks of kBrickSide³, each column of a brick contiguous: voxel (x, y, z) of
 * it has the index (x·kBrickSide + y)·kBrickSide + z. */
constexpr std::int32_t kBrickBits = 4;
constexpr std::int32_t kBrickSide = 1 << kBrickBits;
constexpr std::int32_t kBrickColumns = kBrickSide * kBrickSide;
constexpr std::int32_t kBrickVoxels = kBrickColumns * kBrickSide;
/** Bricks are found through regions of kRegionSide³ bricks, in the same order. */
constexpr std::int32_t kRegionBits = 3;
constexpr std::int32_t kRegionSide = 1 << kRegionBits;
constexpr std::int32_t kRegionBricks = kRegionSide * kRegionSide * kRegionSide;
constexpr std::int32_t kRegionVoxelBits = kBrickBits + kRegionBits;

/** Index of a voxel in its brick. */
constexpr std::size_t voxelIndex(const VoxelKey& voxel)
{
  constexpr std::int32_t mask = kBrickSide - 1;
  return static_cast<std::size_t>(((voxel.x & mask) << 2 * kBrickBits) |
                                  ((voxel.y & mask) << kBrickBits) | (voxel.z & mask));
}
/** Index of a voxel's brick in its region. */
constexpr std::size_t brickIndex(const VoxelKey& voxel)
{
  constexpr std::int32_t mask = kRegionSide - 1;
  return static_cast<std::size_t>(((voxel.x >> kBrickBits & mask) << 2 * kRegionBits) |
                                  ((voxel.y >> kBrickBits & mask) << kRegionBits) |
                                  (voxel.z >> kBrickBits & mask));
}
/** The key of a voxel's region. */
constexpr VoxelKey regionKey(const VoxelKey& voxel)
{
  return {voxel.x >> kRegionVoxelBits, voxel.y >> kRegionVoxelBits, voxel.z >> kRegionVoxelBits};
}
/** The lowest voxel of a brick of a region. */
constexpr VoxelKey brickOrigin(const VoxelKey& region, std::size_t brick)
{
  const auto index = static_cast<std::int32_t>(brick);
  constexpr std::int32_t mask = kRegionSide - 1;
  const auto origin = [](std::int32_t key, std::int32_t inRegion)
  { return key * (1 << kRegionVoxelBits) + inRegion * kBrickSide; };
  return {origin(region.x, index >> 2 * kRegionBits), origin(region.y, index >> kRegionBits & mask),
          origin(region.z, index & mask)};
}

/** A sparse grid of bricks: a hash table of regions, each an array of its bricks' slots. A region
 * stays where it is in memory until the table is cleared. */
template <class Slot>
class RegionTable
{
 public:
  using Region = std::array<Slot, kRegionBricks>;
  using Regions = std::unordered_map<VoxelKey, std::unique_ptr<Region>, VoxelKeyHash>;

  /** Null if there is none. */
  const Region* find(const VoxelKey& key) const
  {
    const auto it = m_regions.find(key);
    return it == m_regions.end() ? nullptr : it->second.get();
  }
  /** Makes it if there is none. */
  Region& obtain(const VoxelKey& key)
  {
    auto& region = m_regions[key];
    if (!region) region = std::make_unique<Region>();
    return *region;
  }
  const Regions& regions() const { return m_regions; }
  std::size_t size() const { return m_regions.size(); }
  bool empty() const { return m_regions.empty(); }
  void clear() { m_regions.clear(); }

  /** Calls visit(key, region) for every region. */
  template <class Visit>
  void forEachRegion(const Visit& visit)
  {
    for (auto& [key, region] : m_regions) visit(key, *region);
  }

  /** Calls visit(lowest voxel, slot) for every slot of every region. */
  template <class Visit>
  void forEachSlot(const Visit& visit) const
  {
    for (const auto& [key, region] : m_regions)
      for (std::size_t i = 0; i < region->size(); ++i) visit(brickOrigin(key, i), (*region)[i]);
  }

  static constexpr std::size_t bytesOfRegion()
  {
    return sizeof(Region) + sizeof(typename Regions::value_type) + 2 * sizeof(void*);
  }

 private:
  Regions m_regions;
};

}  // namespace mrpt_mapconv::voxel
