#pragma once

#include <mrpt_mapconv/voxel/RegionTable.h>

#include <array>
#include <unordered_map>

namespace mrpt_mapconv::voxel
{
/** What somebody notes of the regions that he has come to, found at once if he was there lately. */
template <class Region>
class KnownRegions
{
 public:
  KnownRegions() = default;
  KnownRegions(KnownRegions&&) = default;
  KnownRegions& operator=(KnownRegions&&) = default;

  /** \param make called for a region that is new here: make(key, region) */
  template <class Make>
  Region& operator()(const VoxelKey& key, const Make& make)
  {
    auto& recent = m_recent[VoxelKeyHash()(key) % m_recent.size()];
    if (!recent.region || recent.key != key)
    {
      const auto [it, isNew] = m_regions.try_emplace(key);
      if (isNew) make(key, it->second);
      recent = {key, &it->second};
    }
    return *recent.region;
  }
  const auto& all() const { return m_regions; }

 private:
  struct Recent
  {
    VoxelKey key;
    Region* region = nullptr;
  };
  std::unordered_map<VoxelKey, Region, VoxelKeyHash> m_regions;
  std::array<Recent, 256> m_recent{};
};

}  // namespace mrpt_mapconv::voxel
