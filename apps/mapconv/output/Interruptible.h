#pragma once

#include <mrpt_mapconv/files/OutputDir.h>
#include <signal.h>

#include <functional>
#include <mutex>
#include <thread>
#include <vector>

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

  using Outputs = std::vector<mrpt_mapconv::files::OutputDir*>;
  /** Says what is being staged, until the result goes out of scope, which must be before `outs`
   * do. */
  class Watch
  {
   public:
    explicit Watch(Interruptible& interruptible) : m_interruptible(interruptible) {}
    ~Watch() { m_interruptible.set({}); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    Interruptible& m_interruptible;
  };
  [[nodiscard]] Watch watch(const Outputs& outs)
  {
    set(outs);
    return Watch(*this);
  }
  /** Has them moved to their places; signals wait until that is done. */
  void commit(const std::function<void()>& move);

 private:
  void set(const Outputs& outs);
  void wait();

  sigset_t m_signals;
  std::mutex m_mutex;
  Outputs m_outs;
  std::thread m_waiter;
};

}  // namespace mapconv
