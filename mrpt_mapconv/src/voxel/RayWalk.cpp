#include <mrpt_mapconv/voxel/RayWalk.h>

#include <stdexcept>

namespace mrpt_mapconv::voxel
{
namespace
{
/** Notes the keys of the voxels that a walk comes to. */
class KeyList
{
 public:
  explicit KeyList(std::vector<VoxelKey>& keys) : m_keys(keys) {}
  const VoxelKey& region(const VoxelKey& key)
  {
    m_region = key;
    return m_region;
  }
  static VoxelKey brick(const VoxelKey& region, std::size_t index)
  {
    return brickOrigin(region, index);
  }
  void cross(const VoxelKey& origin, std::size_t index)
  {
    constexpr std::int32_t mask = kBrickSide - 1;
    const auto i = static_cast<std::int32_t>(index);
    m_keys.push_back({origin.x + (i >> 2 * kBrickBits), origin.y + (i >> kBrickBits & mask),
                      origin.z + (i & mask)});
  }
  void end(const VoxelKey& origin, std::size_t index) { cross(origin, index); }

 private:
  std::vector<VoxelKey>& m_keys;
  VoxelKey m_region;
};
}  // namespace

std::vector<VoxelKey> voxelsOnRay(const GridRay& ray)
{
  constexpr std::int64_t most = 100'000'000;
  std::int64_t count = 1;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::int64_t steps = (ray.to[i] >> kRayBits) - (ray.from[i] >> kRayBits);
    count += steps < 0 ? -steps : steps;
  }
  if (count > most)
    throw std::length_error("a ray of " + std::to_string(count) + " voxels is too long for a list");
  std::vector<VoxelKey> keys;
  keys.reserve(static_cast<std::size_t>(count));
  KeyList list(keys);
  walkRay(ray, {}, list);
  return keys;
}

}  // namespace mrpt_mapconv::voxel
