#pragma once

#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace octomap
{
class AbstractOcTree;
}

namespace mrpt_mapconv::voxel
{
/** The nodes of an OctoMap file. */
struct OctreeNodes
{
  std::string bytes;
  std::uint64_t count = 0;
};

/** The nodes of the octree with a grid's voxels, whose inner nodes have the largest log-odds below
 * them: those of an `.ot` file, or, with two bits for each child, of a `.bt` file.
 * \param pruned eight equal children that have none themselves become one node
 * \exception std::runtime_error if the grid reaches beyond an octree's range of ±32768 voxels */
OctreeNodes fullNodes(const VoxelGrid& grid, bool pruned);
OctreeNodes binaryNodes(const VoxelGrid& grid, bool pruned);

/** Fills an empty grid with the leaves of an `.ot` file's nodes, which have to be whole.
 * \param maxMemory of the grid [MB]; none: see memoryLimit()
 * \exception std::runtime_error if the grid would exceed it */
void addFullNodes(std::string_view bytes, const std::optional<std::int32_t>& maxMemory,
                  VoxelGrid& grid);
/** The same with the leaves of a tree of whichever occupancy type.
 * \exception std::invalid_argument for a tree that holds no occupancy */
void addLeaves(const octomap::AbstractOcTree& tree, const std::optional<std::int32_t>& maxMemory,
               VoxelGrid& grid);

}  // namespace mrpt_mapconv::voxel
