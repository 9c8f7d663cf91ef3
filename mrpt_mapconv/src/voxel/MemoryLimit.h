#pragma once

#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace mrpt_mapconv::voxel
{
/** maxMemory in bytes: what was asked for [MB], or else three quarters of the machine's memory. */
std::size_t memoryLimit(const std::optional<std::int32_t>& maxMemory);

/** \param more bytes that an insertion adds at most
 * \exception std::runtime_error naming maxMemory and by how much it is exceeded */
void requireMemory(const VoxelGrid& grid, std::size_t more,
                   const std::optional<std::int32_t>& maxMemory);

}  // namespace mrpt_mapconv::voxel
