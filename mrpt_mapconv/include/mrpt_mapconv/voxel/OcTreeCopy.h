#pragma once

#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace octomap
{
class AbstractOcTree;
class OcTree;
}  // namespace octomap

namespace mrpt_mapconv::voxel
{
/** A plain occupancy tree with the same leaves and log-odds as a tree of any occupancy type.
 * \exception std::invalid_argument for a tree that holds no occupancy */
std::unique_ptr<octomap::OcTree> toOcTree(const octomap::AbstractOcTree& tree);

/** The octree of a grid's voxels; a voxel of it is occupied from the grid's occupiedFrom() on.
 * \param pruned eight equal children become one node
 * \exception std::runtime_error if the grid reaches beyond an octree's range of ±32768 voxels */
std::unique_ptr<octomap::OcTree> toOcTree(const VoxelGrid& grid, bool pruned = true);

/** The voxels of an octree, with the same log-odds (−0, which stands for a voxel that was never
 * touched, becomes 0).
 * \param maxMemory of the grid [MB]; none: three quarters of the machine's
 * \exception std::invalid_argument for a tree that holds no occupancy
 * \exception std::runtime_error if the grid would exceed maxMemory */
VoxelGrid toVoxelGrid(const octomap::AbstractOcTree& tree,
                      const std::optional<std::int32_t>& maxMemory = {});

}  // namespace mrpt_mapconv::voxel
