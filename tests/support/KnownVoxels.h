#pragma once

#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>
#include <octomap/octomap.h>

#include <algorithm>
#include <cstring>
#include <tuple>
#include <vector>

namespace mrpt_mapconv::test
{
/** A voxel that is known, with the bits of its log-odds. */
struct KnownVoxel
{
  voxel::VoxelKey key;
  std::uint32_t bits = 0;

  bool operator==(const KnownVoxel& o) const { return key == o.key && bits == o.bits; }
  bool operator<(const KnownVoxel& o) const
  {
    return std::tie(key.x, key.y, key.z) < std::tie(o.key.x, o.key.y, o.key.z);
  }
};
using KnownVoxels = std::vector<KnownVoxel>;

inline std::uint32_t bitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

/** Every finest voxel of a tree, by OctoMap's own leaf iterator; sorted. */
template <class Tree>
KnownVoxels knownVoxels(const Tree& tree)
{
  KnownVoxels voxels;
  for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf)
  {
    const octomap::OcTreeKey first = leaf.getIndexKey();
    const int side = 1 << (tree.getTreeDepth() - leaf.getDepth());
    for (int x = 0; x < side; ++x)
      for (int y = 0; y < side; ++y)
        for (int z = 0; z < side; ++z)
          voxels.push_back({{first[0] - 32768 + x, first[1] - 32768 + y, first[2] - 32768 + z},
                            bitsOf(leaf->getLogOdds())});
  }
  std::sort(voxels.begin(), voxels.end());
  return voxels;
}

/** Every touched voxel of a grid; sorted. */
inline KnownVoxels knownVoxels(const voxel::VoxelGrid& grid)
{
  KnownVoxels voxels;
  grid.table().forEachSlot(
      [&voxels](const voxel::VoxelKey& lowest, const voxel::VoxelGrid::Slot& slot)
      {
        if (slot.isUntouched()) return;
        for (int x = 0; x < voxel::kBrickSide; ++x)
          for (int y = 0; y < voxel::kBrickSide; ++y)
            for (int z = 0; z < voxel::kBrickSide; ++z)
            {
              const voxel::VoxelKey key{lowest.x + x, lowest.y + y, lowest.z + z};
              const float logOdds = slot.at(voxel::voxelIndex(key));
              if (voxel::isTouched(logOdds)) voxels.push_back({key, bitsOf(logOdds)});
            }
      });
  std::sort(voxels.begin(), voxels.end());
  return voxels;
}

/** Whether two maps know the same voxels, with the same bits; if not, the first that differs. */
inline ::testing::AssertionResult sameVoxels(const KnownVoxels& a, const KnownVoxels& b)
{
  if (a == b) return ::testing::AssertionSuccess();
  const auto [left, right] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  auto result = ::testing::AssertionFailure() << a.size() << " and " << b.size() << " voxels; ";
  const auto add =
      [&result](const char* name, const KnownVoxels& all, KnownVoxels::const_iterator v)
  {
    result << name << " (";
    if (v != all.end())
      result << v->key.x << ", " << v->key.y << ", " << v->key.z << ") " << std::hex << v->bits
             << std::dec;
    result << ")  ";
  };
  add("first difference:", a, left);
  add("against", b, right);
  return result;
}

template <class A, class B>
::testing::AssertionResult sameVoxels(const A& a, const B& b)
{
  return sameVoxels(knownVoxels(a), knownVoxels(b));
}

}  // namespace mrpt_mapconv::test
