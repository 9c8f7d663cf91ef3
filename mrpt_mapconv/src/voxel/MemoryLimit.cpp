#include "MemoryLimit.h"

#include <mrpt/core/format.h>
#include <mrpt_mapconv/params/MemoryLimit.h>

#include <stdexcept>

namespace mrpt_mapconv::voxel
{
namespace
{
/** \exception std::runtime_error unless `now` and `more` bytes are within the limit */
void require(std::size_t now, std::size_t more, const std::optional<std::int32_t>& maxMemory)
{
  const std::size_t limit = params::memoryLimit(maxMemory);
  if (more <= limit && now <= limit - more) return;
  const auto inMegabytes = [](std::size_t bytes)
  { return static_cast<double>(bytes) / params::kMegabyte; };
  throw std::runtime_error(mrpt::format(
      "the voxel map of %.1f MB would need at least %.1f MB more than it has, which exceeds "
      "maxMemory = %.0f MB%s; larger voxels, a smaller maximum range or a larger maxMemory would "
      "do",
      inMegabytes(now), inMegabytes(more), inMegabytes(limit), maxMemory ? "" : " (auto)"));
}
}  // namespace

void reserveMemory(VoxelGrid& grid, std::size_t more, const std::optional<std::int32_t>& maxMemory)
{
  const std::size_t limit = params::memoryLimit(maxMemory);
  if (more > limit || grid.heapBytesAtMost() > limit - more)
  {
    grid.countHeapBytes();
    require(grid.heapBytesAtMost(), more, maxMemory);
  }
  grid.announce(more);
}

void MemoryBudget::countExactly()
{
  const std::size_t now = m_grid.heapBytes();
  require(now, m_own, m_maxMemory);
  m_taken = now + m_own;
}

}  // namespace mrpt_mapconv::voxel
