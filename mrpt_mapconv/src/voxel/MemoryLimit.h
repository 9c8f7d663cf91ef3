#pragma once

#include <mrpt_mapconv/params/MemoryLimit.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace mrpt_mapconv::voxel
{
/** Announces to a grid that it is going to grow. Counts what it has only if it may become too much.
 * \param more bytes that it grows by at most
 * \exception std::runtime_error naming maxMemory and by how much it is exceeded */
void reserveMemory(VoxelGrid& grid, std::size_t more, const std::optional<std::int32_t>& maxMemory);

/** What an insertion may still take beside a grid for what it has to note; threads share it. */
class MemoryBudget
{
 public:
  MemoryBudget(const VoxelGrid& grid, const std::optional<std::int32_t>& maxMemory)
      : m_grid(grid),
        m_maxMemory(maxMemory),
        m_limit(params::memoryLimit(maxMemory)),
        m_taken(grid.heapBytesAtMost())
  {
  }
  /** \exception std::runtime_error as reserveMemory(), if there is less */
  void take(std::size_t bytes)
  {
    m_own += bytes;
    if ((m_taken += bytes) > m_limit) countExactly();
  }

 private:
  void countExactly();

  const VoxelGrid& m_grid;
  std::optional<std::int32_t> m_maxMemory;
  std::size_t m_limit;
  std::atomic<std::size_t> m_taken;   //!< with the grid's
  std::atomic<std::size_t> m_own{0};  //!< without
};

}  // namespace mrpt_mapconv::voxel
