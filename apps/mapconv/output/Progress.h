#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace mapconv
{
/** Shows how far the work is: on a terminal as a line that moves, from the second second on;
 * elsewhere, as in a log, by a line every ten seconds.
 *
 * Written by a thread of its own, so that it also moves during work that reports nothing.
 */
class Progress
{
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /** Begins a stage, e.g. "reading map.bt", of which it is not known how far it is. */
  void stage(const std::string& name);
  /** How much of the present stage is done, 0 … 1. */
  void done(double share);

 private:
  void showUntilStopped();
  void draw() const;
  void printLine() const;
  int secondsPassed() const;

  const bool m_onTerminal;
  const std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
  std::mutex m_mutex;
  std::condition_variable m_stopped;
  bool m_stop = false;
  std::string m_name;
  double m_share = -1;  //!< negative: not known
  std::thread m_thread;
};

/** Seconds since it was made or last asked. */
class Stopwatch
{
 public:
  double lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - m_last;
    m_last = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

}  // namespace mapconv
