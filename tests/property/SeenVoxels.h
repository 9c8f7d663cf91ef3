#pragma once

#include <mrpt_mapconv/voxel/RayWalk.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace mrpt_mapconv::test
{
__extension__ using Wide = __int128;

inline std::string text(const voxel::GridRay& ray)
{
  std::ostringstream out;
  for (const auto& end : {ray.from, ray.to})
    for (const std::int64_t units : end) out << ' ' << units;
  return out.str();
}

inline std::string text(const std::vector<voxel::VoxelKey>& voxels)
{
  std::ostringstream out;
  for (const auto& v : voxels) out << " (" << v.x << ' ' << v.y << ' ' << v.z << ')';
  return out.str();
}

/** The voxels that a walk shows its visitor, and whether the last of them is the ray's end. */
class SeenVoxels
{
 public:
  const voxel::VoxelKey& region(const voxel::VoxelKey& key)
  {
    m_region = key;
    return m_region;
  }
  static voxel::VoxelKey brick(const voxel::VoxelKey& region, std::size_t index)
  {
    return voxel::brickOrigin(region, index);
  }
  void cross(const voxel::VoxelKey& origin, std::size_t index)
  {
    const auto i = static_cast<std::int32_t>(index);
    constexpr std::int32_t side = voxel::kBrickSide;
    voxels.push_back(
        {origin.x + i / (side * side), origin.y + i / side % side, origin.z + i % side});
  }
  void end(const voxel::VoxelKey& origin, std::size_t index)
  {
    cross(origin, index);
    ++ends;
  }

  std::vector<voxel::VoxelKey> voxels;
  int ends = 0;

 private:
  voxel::VoxelKey m_region;
};

template <class Int>
SeenVoxels seenAs(const voxel::GridRay& ray, const voxel::Slab& slab = {})
{
  SeenVoxels seen;
  voxel::walkRayAs<Int>(ray, slab, seen);
  return seen;
}

inline std::int64_t keyOn(int axis, const voxel::VoxelKey& v)
{
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

}  // namespace mrpt_mapconv::test
