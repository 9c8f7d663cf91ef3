#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace mrpt_mapconv::grid
{
/** How many threads are meant: 0 = all cores. */
inline std::size_t threadCount(int threads)
{
  return static_cast<std::size_t>(threads > 0 ? threads : tbb::this_task_arena::max_concurrency());
}

/** Runs work(begin, end) over parts of [0, count) on up to `threads` threads (0 = all cores). A
 * part is worked on by one thread, which may thus keep scratch memory for it. */
template <class Work>
void inParallel(std::size_t count, int threads, const Work& work)
{
  if (threads == 1)
  {
    work(std::size_t{0}, count);
    return;
  }
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute(
      [&]
      {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                          [&](const auto& part) { work(part.begin(), part.end()); });
      });
}

}  // namespace mrpt_mapconv::grid
