#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <future>
#include <vector>
#endif

namespace mrpt_mapconv::grid
{
/** How many threads are meant: 0 = all cores. */
inline std::size_t threadCount(int threads)
{
  return static_cast<std::size_t>(threads > 0 ? threads : tbb::this_task_arena::max_concurrency());
}

#ifdef __SANITIZE_THREAD__
/** As inParallel(), without TBB: ThreadSanitizer does not see that a thread waits for another
 * there. */
template <class Work>
void inWatchedThreads(std::size_t count, std::size_t threads, const Work& work)
{
  std::atomic<std::size_t> next{0};
  const auto workOnRest = [&]
  {
    std::size_t i;
    while ((i = next.fetch_add(1, std::memory_order_relaxed)) < count) work(i, i + 1);
  };
  std::vector<std::future<void>> helpers;
  for (std::size_t t = 0; t < threads; ++t)
    helpers.push_back(std::async(std::launch::async, workOnRest));
  for (auto& helper : helpers) helper.get();
}
#endif

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
#ifdef __SANITIZE_THREAD__
  inWatchedThreads(count, threadCount(threads), work);
#else
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute(
      [&]
      {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                          [&](const auto& part) { work(part.begin(), part.end()); });
      });
#endif
}

}  // namespace mrpt_mapconv::grid
