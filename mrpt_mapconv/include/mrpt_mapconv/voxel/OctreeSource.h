#pragma once

#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <memory>

namespace octomap
{
class AbstractOcTree;
}

namespace mrpt_mapconv::voxel
{
/** OctoMap's unsigned key of coordinate 0: its keys minus this are ours. */
constexpr std::int32_t kOctomapKeyOffset = 32768;

/** Reads any OctoMap occupancy tree by walking its nodes (instantiated for OcTree, ColorOcTree and
 * OcTreeStamped).
 *
 * A leaf is occupied if the tree says so (isNodeOccupied), else free; a missing leaf is unknown;
 * inner nodes never count; a pruned leaf stands for all the finest voxels that it covers. The tree
 * must outlive the source and must not change while it is read.
 */
template <class Tree>
class OctreeSource : public VoxelSource
{
 public:
  explicit OctreeSource(const Tree& tree) : m_tree(tree) {}
  double resolution() const override;
  std::optional<KeyRect> bounds() const override;
  void read(ColumnBlock& block) const override;
  std::optional<std::int32_t> top() const override;

 private:
  const Tree& m_tree;
};

/** The source that fits a tree of whichever occupancy type.
 * \exception std::invalid_argument for a tree that does not store occupancy, with its type's name
 */
std::unique_ptr<VoxelSource> makeOctreeSource(const octomap::AbstractOcTree& tree);

}  // namespace mrpt_mapconv::voxel
