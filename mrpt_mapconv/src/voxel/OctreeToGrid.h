#pragma once

#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace octomap
{
class AbstractOcTree;
}

namespace mrpt_mapconv::voxel
{
/** What the next two throw of a leaf that would need too many bricks. */
struct LeafTooLarge : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** Fills an empty grid with the leaves of an `.ot` file's nodes, which have to be whole.
 * \param maxMemory of the grid [MB]; none: see params::memoryLimit()
 * \exception std::runtime_error if the grid would exceed it */
void addFullNodes(std::string_view bytes, const std::optional<std::int32_t>& maxMemory,
                  VoxelGrid& grid);
/** The same with the leaves of a tree of whichever occupancy type.
 * \exception std::invalid_argument for a tree that holds no occupancy */
void addLeaves(const octomap::AbstractOcTree& tree, const std::optional<std::int32_t>& maxMemory,
               VoxelGrid& grid);

}  // namespace mrpt_mapconv::voxel
