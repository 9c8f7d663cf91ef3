#pragma once

#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <cstdint>
#include <string>

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

}  // namespace mrpt_mapconv::voxel
