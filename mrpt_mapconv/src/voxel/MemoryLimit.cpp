#include "MemoryLimit.h"

#include <mrpt/core/format.h>
#include <unistd.h>

#include <stdexcept>

namespace mrpt_mapconv::voxel
{
namespace
{
constexpr double kMegabyte = 1e6;
}

std::size_t memoryLimit(const std::optional<std::int32_t>& maxMemory)
{
  if (maxMemory) return static_cast<std::size_t>(*maxMemory * kMegabyte);
  const auto pages = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES));
  return pages / 4 * 3 * static_cast<std::size_t>(sysconf(_SC_PAGE_SIZE));
}

void requireMemory(const VoxelGrid& grid, std::size_t more,
                   const std::optional<std::int32_t>& maxMemory)
{
  const std::size_t limit = memoryLimit(maxMemory), now = grid.heapBytes();
  if (more <= limit && now <= limit - more) return;
  const auto inMegabytes = [](std::size_t bytes) { return static_cast<double>(bytes) / kMegabyte; };
  throw std::runtime_error(mrpt::format(
      "the voxel map of %.1f MB would need at least %.1f MB more than it has, which exceeds "
      "maxMemory = "
      "%.0f MB%s; larger voxels, a smaller maximum range or a larger maxMemory would do",
      inMegabytes(now), inMegabytes(more), inMegabytes(limit), maxMemory ? "" : " (auto)"));
}

}  // namespace mrpt_mapconv::voxel
