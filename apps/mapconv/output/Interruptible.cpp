#include "output/Interruptible.h"

#include <csignal>

namespace mapconv
{
namespace
{
constexpr int kStop = SIGUSR1;  // tells our own thread to end
}

Interruptible::Interruptible()
{
  sigemptyset(&m_signals);
  sigaddset(&m_signals, kStop);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
  {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&m_signals, signal);  // nohup ignores SIGHUP, say
  }
  pthread_sigmask(SIG_BLOCK, &m_signals, nullptr);
  m_waiter = std::thread([this] { wait(); });
}

Interruptible::~Interruptible()
{
  pthread_kill(m_waiter.native_handle(), kStop);
  m_waiter.join();
  pthread_sigmask(SIG_UNBLOCK, &m_signals, nullptr);
}

void Interruptible::set(const Outputs& outs)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_outs = outs;
}

void Interruptible::commit(const std::function<void()>& move)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_outs.clear();
  move();
}

void Interruptible::wait()
{
  int signal = 0;
  while (sigwait(&m_signals, &signal) != 0) continue;
  if (signal == kStop) return;
  const std::lock_guard<std::mutex> lock(m_mutex);
  for (auto* out : m_outs) out->discard();
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &m_signals, nullptr);
  std::raise(signal);  // the caller sees that a signal has ended us
}

}  // namespace mapconv
