#include <mrpt_mapconv/params/MemoryLimit.h>
#include <mrpt_mapconv/params/Require.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace mrpt_mapconv::params
{
namespace
{
/** What the machine has, or the container may use. */
std::size_t findMemory()
{
  const auto machine = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
                       static_cast<std::size_t>(sysconf(_SC_PAGE_SIZE));
  std::size_t container = 0;  // "max" where there is no limit, which is no number
  std::ifstream("/sys/fs/cgroup/memory.max") >> container;
  return container > 0 ? std::min(machine, container) : machine;
}
}  // namespace

std::size_t memoryLimit()
{
  static const std::size_t bytes = findMemory();
  return bytes / 4 * 3;
}

std::size_t memoryLimit(const std::optional<std::int32_t>& maxMemory)
{
  params::require(!maxMemory || *maxMemory > 0, "maxMemory", maxMemory.value_or(0),
                  "above 0 MB, or auto");
  return maxMemory ? static_cast<std::size_t>(*maxMemory * kMegabyte) : memoryLimit();
}

}  // namespace mrpt_mapconv::params
