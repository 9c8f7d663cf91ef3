#pragma once

#include <octomap/octomap.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace mrpt_mapconv::oracle
{
enum class Voxel : std::uint8_t
{
  Unknown,
  Free,
  Occupied
};

/** A voxel map as a plain array, one entry per finest voxel of its bounding box.
 *
 * Signed keys (an OctoMap key minus 32768); voxel (x0 + ix, y0 + iy, z0 + iz) is at(ix, iy, iz). */
struct DenseMap
{
  double resolution = 0;
  int x0 = 0, y0 = 0, z0 = 0;  //!< key of the first voxel
  int nx = 0, ny = 0, nz = 0;  //!< size in voxels; all 0 if nothing is known
  std::vector<Voxel> voxels;

  Voxel& at(int ix, int iy, int iz) { return voxels[index(ix, iy, iz)]; }
  Voxel at(int ix, int iy, int iz) const { return voxels[index(ix, iy, iz)]; }

 private:
  std::size_t index(int ix, int iy, int iz) const
  {
    const auto cell =
        static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(ix);
    return cell * static_cast<std::size_t>(nz) + static_cast<std::size_t>(iz);
  }
};

constexpr int kKeyOrigin = 32768;  //!< OctoMap's key of the voxel that begins at 0 m

inline octomap::OcTreeKey octomapKey(int kx, int ky, int kz)
{
  return {static_cast<octomap::key_type>(kx + kKeyOrigin),
          static_cast<octomap::key_type>(ky + kKeyOrigin),
          static_cast<octomap::key_type>(kz + kKeyOrigin)};
}

/** What the tree itself says about one finest voxel. */
template <class Tree>
Voxel askTree(const Tree& tree, int kx, int ky, int kz)
{
  // search() at the finest depth returns the voxel, the pruned leaf that covers it, or nothing
  const auto* node = tree.search(octomapKey(kx, ky, kz));
  if (!node) return Voxel::Unknown;
  return tree.isNodeOccupied(node) ? Voxel::Occupied : Voxel::Free;
}

/** Only the bounding box of all leaves, by OctoMap's own leaf iterator; no voxels yet. */
template <class Tree>
DenseMap boundsOf(const Tree& tree)
{
  constexpr int kHigh = std::numeric_limits<int>::max(), kLow = std::numeric_limits<int>::min();
  int low[3] = {kHigh, kHigh, kHigh}, high[3] = {kLow, kLow, kLow};
  for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf)
  {
    const octomap::OcTreeKey first = leaf.getIndexKey();  // lowest corner
    const int side = 1 << (tree.getTreeDepth() - leaf.getDepth());
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], first[axis] - kKeyOrigin);
      high[axis] = std::max(high[axis], first[axis] - kKeyOrigin + side);
    }
  }
  DenseMap map;
  map.resolution = tree.getResolution();
  if (low[0] == kHigh) return map;
  map.x0 = low[0], map.y0 = low[1], map.z0 = low[2];
  map.nx = high[0] - low[0], map.ny = high[1] - low[1], map.nz = high[2] - low[2];
  return map;
}

/** The whole tree, asked voxel by voxel. */
template <class Tree>
DenseMap denseMap(const Tree& tree)
{
  DenseMap map = boundsOf(tree);
  map.voxels.assign(static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny) *
                        static_cast<std::size_t>(map.nz),
                    Voxel::Unknown);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      for (int iz = 0; iz < map.nz; ++iz)
        map.at(ix, iy, iz) = askTree(tree, map.x0 + ix, map.y0 + iy, map.z0 + iz);
  return map;
}

}  // namespace mrpt_mapconv::oracle
