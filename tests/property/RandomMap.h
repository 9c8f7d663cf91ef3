#pragma once

#include <octomap/octomap.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "../oracle/DenseMap.h"

namespace mrpt_mapconv::test
{
using Rng = std::mt19937;

/** A whole number in [low, high]. Not std::uniform_int_distribution: its numbers differ between
 * standard libraries, and a printed seed must give the same map everywhere. */
inline int pick(Rng& rng, int low, int high)
{
  return low + static_cast<int>(rng() % static_cast<unsigned>(high - low + 1));
}
inline bool chance(Rng& rng, int percent) { return pick(rng, 1, 100) <= percent; }
inline double uniform(Rng& rng, double low, double high)
{
  return low + (high - low) * (static_cast<double>(rng()) / 4294967296.0);
}

/** What a random map is made of. */
enum class MapKind
{
  Noise,     //!< every voxel on its own
  Columns,   //!< columns of random runs
  Building,  //!< terrain, walls and slabs
  Plane,     //!< an exact, perhaps patchy plane: ties of the slope
  Sparse,    //!< few columns, many of them on one line
  Cubes      //!< aligned cubes of all sizes: pruned leaves
};
constexpr int kMapKinds = 6;

struct MapShape
{
  MapKind kind = MapKind::Noise;
  int x0 = 0, y0 = 0, z0 = 0;
  int nx = 1, ny = 1, nz = 1;
  std::string text() const;
};

/** A shape of at most 45×45×150 voxels anywhere that OctoMap's keys reach. */
MapShape randomShape(Rng& rng);

/** States for all voxels of a shape. */
oracle::DenseMap randomVoxels(Rng& rng, const MapShape& shape);

/** Writes states into a tree: unknown voxels are left out, others get a leaf. With `mixed`, leaves
 * get many log-odds (those on the threshold too), so that little can be pruned. */
template <class Tree>
void fillTree(Rng& rng, const oracle::DenseMap& map, bool mixed, Tree& tree)
{
  static const float kFree[] = {-2.0f, -0.4f, -0.01f}, kOccupied[] = {3.5f, 0.85f, 0.0f};
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      for (int iz = 0; iz < map.nz; ++iz)
      {
        const oracle::Voxel state = map.at(ix, iy, iz);
        if (state == oracle::Voxel::Unknown) continue;
        const int level = mixed ? pick(rng, 0, 2) : 0;
        tree.setNodeValue(oracle::octomapKey(map.x0 + ix, map.y0 + iy, map.z0 + iz),
                          state == oracle::Voxel::Free ? kFree[level] : kOccupied[level], true);
      }
}

/** Deletes one voxel, of a pruned leaf too, unless it is its parent's last child: OctoMap 1.9 stops
 * with a failed assertion when a node loses its last child. */
template <class Tree>
void deleteVoxel(Tree& tree, const octomap::OcTreeKey& key)
{
  const auto* parent = tree.search(key, tree.getTreeDepth() - 1);
  if (!parent) return;
  int children = 0;
  for (unsigned i = 0; i < 8; ++i) children += tree.nodeChildExists(parent, i) ? 1 : 0;
  if (children != 1) tree.deleteNode(key);  // none: a pruned leaf, which gets eight first
}

/** Deletes some voxels, one by one and a whole box. */
template <class Tree>
void deleteSome(Rng& rng, const MapShape& shape, Tree& tree)
{
  const int sx = pick(rng, 1, 5), sy = pick(rng, 1, 5), sz = pick(rng, 1, 20);
  const int bx = pick(rng, 0, shape.nx), by = pick(rng, 0, shape.ny), bz = pick(rng, 0, shape.nz);
  const auto deleteOne = [&](int ix, int iy, int iz)
  {
    if (ix >= shape.nx || iy >= shape.ny || iz >= shape.nz) return;
    deleteVoxel(tree, oracle::octomapKey(shape.x0 + ix, shape.y0 + iy, shape.z0 + iz));
  };
  for (int ix = bx; ix < bx + sx; ++ix)
    for (int iy = by; iy < by + sy; ++iy)
      for (int iz = bz; iz < bz + sz; ++iz) deleteOne(ix, iy, iz);
  for (int i = 0; i < 5; ++i)
    deleteOne(pick(rng, 0, shape.nx - 1), pick(rng, 0, shape.ny - 1), pick(rng, 0, shape.nz - 1));
}

/** A tree of a random map; inner nodes are only sometimes brought up to date, since they never
 * count. Never empty. */
template <class Tree>
void randomTree(Rng& rng, const MapShape& shape, Tree& tree)
{
  const oracle::DenseMap voxels = randomVoxels(rng, shape);
  fillTree(rng, voxels, chance(rng, 40), tree);
  if (tree.size() == 0)
    tree.setNodeValue(oracle::octomapKey(shape.x0, shape.y0, shape.z0), -0.4f, true);
  // what is occupied is the tree's own decision
  if (chance(rng, 15)) tree.setOccupancyThres(chance(rng, 50) ? 0.7 : 0.3);
  if (chance(rng, 70)) tree.prune();
  if (chance(rng, 40)) deleteSome(rng, shape, tree);
  if (chance(rng, 50)) tree.updateInnerOccupancy();
}

}  // namespace mrpt_mapconv::test
