#pragma once

#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace mrpt_mapconv::voxel
{
/** maxMemory in bytes: what was asked for [MB], or else three quarters of the machine's memory. */
std::size_t memoryLimit(const std::optional<std::int32_t>& maxMemory);

/** \param more bytes that an insertion needs, as far as it was counted
 * \exception std::runtime_error naming maxMemory and by how much it is exceeded */
void requireMemory(const VoxelGrid& grid, std::size_t more,
                   const std::optional<std::int32_t>& maxMemory);

/** What an insertion may still take beside a grid for what it has to note; threads share it. */
class MemoryBudget
{
 public:
  MemoryBudget(const VoxelGrid& grid, const std::optional<std::int32_t>& maxMemory)
      : m_grid(grid), m_maxMemory(maxMemory), m_limit(memoryLimit(maxMemory))
  {
  }
  /** \exception std::runtime_error as requireMemory(), if there is less */
  void take(std::size_t bytes)
  {
    if ((m_taken += bytes) > m_limit) requireMemory(m_grid, m_taken, m_maxMemory);
  }

 private:
  const VoxelGrid& m_grid;
  std::optional<std::int32_t> m_maxMemory;
  std::size_t m_limit;
  std::atomic<std::size_t> m_taken{0};
};

}  // namespace mrpt_mapconv::voxel
