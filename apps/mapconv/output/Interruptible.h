#pragma once

#include <mrpt_mapconv/files/OutputDir.h>
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

  /** Says what is being staged, until the result goes out of scope, which must be before `out`
   * does. */
  class Watch
  {
   public:
    explicit Watch(Interruptible& interruptible) : m_interruptible(interruptible) {}
    ~Watch() { m_interruptible.set(nullptr); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    Interruptible& m_interruptible;
  };
  [[nodiscard]] Watch watch(mrpt_mapconv::files::OutputDir& out)
  {
    set(&out);
    return Watch(*this);
  }
  /** Moves them to their places; signals wait until that is done. */
  void commit();

 private:
  void set(mrpt_mapconv::files::OutputDir* out);
  void wait();

  sigset_t m_signals;
  std::mutex m_mutex;
  mrpt_mapconv::files::OutputDir* m_out = nullptr;
  std::thread m_waiter;
};

}  // namespace mapconv
