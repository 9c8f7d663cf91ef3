#include "output/Progress.h"

#include <mrpt/system/progress.h>
#include <mrpt_mapconv/params/Printable.h>

#include <algorithm>

#include "output/Console.h"

namespace mapconv
{
Progress::Progress() : m_onTerminal(messagesOnTerminal())
{
  m_thread = std::thread([this] { showUntilStopped(); });
}

Progress::~Progress()
{
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_stop = true;
  }
  m_stopped.notify_one();
  m_thread.join();
}

void Progress::stage(const std::string& name)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_name = mrpt_mapconv::params::printable(name);
  m_share = -1;
}

void Progress::done(double share)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_share = std::clamp(share, 0.0, 1.0);
}

void Progress::showUntilStopped()
{
  std::unique_lock<std::mutex> lock(m_mutex);
  const auto stopped = [this] { return m_stop; };
  if (!m_onTerminal)
  {
    while (!m_stopped.wait_for(lock, std::chrono::seconds(10), stopped)) printLine();
    return;
  }
  if (m_stopped.wait_for(lock, std::chrono::seconds(1), stopped)) return;
  do draw();
  while (!m_stopped.wait_for(lock, std::chrono::milliseconds(200), stopped));
  writeMessage("\r\033[K");
}

void Progress::draw() const
{
  if (m_name.empty()) return;
  std::string line = "\r\033[K";
  if (m_share >= 0) line += mrpt::system::progress(m_share, 30) + " ";
  line += m_name + " (" + std::to_string(secondsPassed()) + " s)";
  writeMessage(line);
}

void Progress::printLine() const
{
  if (m_name.empty()) return;
  const std::string share =
      m_share < 0 ? "" : ": " + std::to_string(static_cast<int>(100 * m_share)) + " %";
  writeMessage("mapconv: progress: " + m_name + share + " (" + std::to_string(secondsPassed()) +
               " s)\n");
}

int Progress::secondsPassed() const
{
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - m_start;
  return static_cast<int>(passed.count());
}

}  // namespace mapconv
