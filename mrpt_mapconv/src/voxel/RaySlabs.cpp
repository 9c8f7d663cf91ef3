#include "RaySlabs.h"

#include <limits>
#include <utility>

namespace mrpt_mapconv::voxel
{
namespace
{
constexpr std::size_t kSamples = 4096;  // of rays
constexpr int kPieces = 16;             // of a ray

/** The axis along which rays reach farthest. */
int longestAxis(const std::vector<GridRay>& rays, std::size_t stride)
{
  std::array<double, 3> low{}, high{};
  low.fill(std::numeric_limits<double>::max());
  high.fill(std::numeric_limits<double>::lowest());
  for (std::size_t r = 0; r < rays.size(); r += stride)
    for (std::size_t i = 0; i < 3; ++i)
      for (const auto end : {rays[r].from[i], rays[r].to[i]})
      {
        low[i] = std::min(low[i], static_cast<double>(end));
        high[i] = std::max(high[i], static_cast<double>(end));
      }
  int longest = 0;
  for (int i = 1; i < 3; ++i)
  {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(longest);
    if (high[a] - low[a] > high[b] - low[b]) longest = i;
  }
  return longest;
}

double voxelsOf(const GridRay& ray)
{
  double units = 0;
  for (std::size_t i = 0; i < 3; ++i)
    units += std::abs(static_cast<double>(ray.to[i] - ray.from[i]));
  return units / static_cast<double>(kRayUnits) + 1;
}
}  // namespace

std::vector<Slab> slabsFor(const std::vector<GridRay>& rays, int count)
{
  if (count <= 1 || rays.empty()) return {Slab{}};
  const std::size_t stride = (rays.size() + kSamples - 1) / kSamples;
  const int axis = longestAxis(rays, stride);
  std::vector<std::pair<std::int64_t, double>> pieces;  // brick's key on the axis, voxels
  double sum = 0;
  for (std::size_t r = 0; r < rays.size(); r += stride)
  {
    const auto i = static_cast<std::size_t>(axis);
    const double voxels = voxelsOf(rays[r]) / kPieces;
    const std::int64_t along = rays[r].to[i] - rays[r].from[i];
    for (int piece = 0; piece < kPieces; ++piece)
    {
      const std::int64_t at = rays[r].from[i] + along / (2 * kPieces) * (2 * piece + 1);
      pieces.emplace_back(at >> (kRayBits + kBrickBits), voxels);
      sum += voxels;
    }
  }
  std::sort(pieces.begin(), pieces.end());
  std::vector<Slab> slabs{Slab{axis, INT64_MIN, INT64_MAX}};
  double passed = 0;
  for (const auto& [brick, voxels] : pieces)
  {
    const bool isDue = passed * count >= sum * static_cast<double>(slabs.size());
    const std::int64_t border = brick * kBrickSide;
    if (isDue && border > slabs.back().begin && slabs.size() < static_cast<std::size_t>(count) &&
        brick != pieces.front().first)
    {
      slabs.back().end = border;
      slabs.push_back({axis, border, INT64_MAX});
    }
    passed += voxels;
  }
  return slabs;
}

}  // namespace mrpt_mapconv::voxel
