#pragma once

#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/RegionTable.h>
#include <octomap/octomap_types.h>

#include <cstdint>
#include <optional>

namespace mrpt_mapconv::voxel
{
/** Turns coordinates into keys by the arithmetic of an octree of that resolution, bit for bit; keys
 * are ours, kOctomapKeyOffset less. */
class OctomapKeys
{
 public:
  explicit OctomapKeys(double resolution) : m_resolution(resolution), m_factor(1.0 / resolution) {}

  double resolution() const { return m_resolution; }
  /** Nothing outside a tree's range. */
  std::optional<VoxelKey> keyOf(const octomap::point3d& at) const
  {
    const double x = m_factor * at.x(), y = m_factor * at.y(), z = m_factor * at.z();
    if (!isInside(x) || !isInside(y) || !isInside(z)) return std::nullopt;
    return VoxelKey{floorOf(x), floorOf(y), floorOf(z)};
  }
  /** The middle of a voxel on one axis. */
  double centre(std::int32_t key) const { return (static_cast<double>(key) + 0.5) * m_resolution; }

  /** Whether the voxels of a region are in a tree's range. */
  static bool holds(const VoxelKey& region)
  {
    constexpr std::int32_t end = kOctomapKeyOffset >> kRegionVoxelBits;
    const auto isInside = [](std::int32_t key) { return key >= -end && key < end; };
    return isInside(region.x) && isInside(region.y) && isInside(region.z);
  }

 private:
  static bool isInside(double key) { return key >= -kOctomapKeyOffset && key < kOctomapKeyOffset; }
  /** As std::floor(), which is a call where a processor's own instruction may not be used. */
  static std::int32_t floorOf(double key)
  {
    const auto truncated = static_cast<std::int32_t>(key);
    return truncated - (static_cast<double>(truncated) > key ? 1 : 0);
  }

  double m_resolution, m_factor;
};

}  // namespace mrpt_mapconv::voxel
