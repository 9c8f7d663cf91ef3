#include "MemoryLimit.h"

#include <mrpt/core/format.h>
#include <mrpt_mapconv/params/Require.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace mrpt_mapconv::voxel
{
namespace
{
constexpr double kMegabyte = 1e6;

/** What the machine has, or the container may use. */
std::size_t findMemory()
{
  const auto machine = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
                       static_cast<std::size_t>(sysconf(_SC_PAGE_SIZE));
  std::size_t container = 0;  // "max" where there is no limit, which is no number
  std::ifstream("/sys/fs/cgroup/memory.max") >> container;
  return container > 0 ? std::min(machine, container) : machine;
}

std::size_t machineMemory()
{
  static const std::size_t bytes = findMemory();
  return bytes;
}

/** \exception std::runtime_error unless `now` and `more` bytes are within the limit */
void require(std::size_t now, std::size_t more, const std::optional<std::int32_t>& maxMemory)
{
  const std::size_t limit = memoryLimit(maxMemory);
  if (more <= limit && now <= limit - more) return;
  const auto inMegabytes = [](std::size_t bytes) { return static_cast<double>(bytes) / kMegabyte; };
  throw std::runtime_error(mrpt::format(
      "the voxel map of %.1f MB would need at least %.1f MB more than it has, which exceeds "
      "maxMemory = %.0f MB%s; larger voxels, a smaller maximum range or a larger maxMemory would "
      "do",
      inMegabytes(now), inMegabytes(more), inMegabytes(limit), maxMemory ? "" : " (auto)"));
}
}  // namespace

std::size_t memoryLimit(const std::optional<std::int32_t>& maxMemory)
{
  params::require(!maxMemory || *maxMemory > 0, "maxMemory", maxMemory.value_or(0),
                  "above 0 MB, or auto");
  if (maxMemory) return static_cast<std::size_t>(*maxMemory * kMegabyte);
  return machineMemory() / 4 * 3;
}

void reserveMemory(VoxelGrid& grid, std::size_t more, const std::optional<std::int32_t>& maxMemory)
{
  const std::size_t limit = memoryLimit(maxMemory);
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
