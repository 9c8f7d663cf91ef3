#include "support/CountAllocations.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace
{
std::atomic<bool> counting = false;
std::atomic<std::size_t> allocations = 0;

void* allocate(std::size_t size, std::size_t alignment)
{
  if (counting) ++allocations;
  void* memory = nullptr;
  if (::posix_memalign(&memory, std::max(alignment, sizeof(void*)), std::max<std::size_t>(size, 1)))
    throw std::bad_alloc();
  return memory;
}
}  // namespace

// of the whole test program
void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace mrpt_mapconv::fixtures
{
std::size_t allocationsOf(const std::function<void()>& call)
{
  allocations = 0;
  counting = true;
  call();
  counting = false;
  return allocations;
}

}  // namespace mrpt_mapconv::fixtures
