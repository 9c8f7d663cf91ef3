#pragma once

#include <mrpt_mapconv/grid/OutputDir.h>
#include <signal.h>

#include <mutex>
#include <thread>

namespace mapconv
{
/** While it lives, Ctrl-C (and SIGTERM, SIGHUP) removes the staged outputs before the program ends.
 * To be made before any other thread: threads inherit that they leave these signals to it. */
class Interruptible
{
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /** The outputs being staged; null when they are in place or gone. */
  void watch(mrpt_mapconv::grid::OutputDir* out);

 private:
  void wait();

  sigset_t m_signals;
  std::mutex m_mutex;
  mrpt_mapconv::grid::OutputDir* m_out = nullptr;
  std::thread m_waiter;
};

}  // namespace mapconv
