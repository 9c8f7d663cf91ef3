#include "output/Console.h"

#include <fcntl.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/params/Printable.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <string_view>
#include <utility>

namespace mapconv
{
namespace params = mrpt_mapconv::params;

namespace
{
/** Where our messages go. As the descriptors it stands for, there is one for the whole process. */
int& messageFile()
{
  static int file = STDERR_FILENO;
  return file;
}

void flushAll()
{
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
}

/** Gives `file` a second, private number and lets everybody else's writes to it vanish. */
int takeOver(int file)
{
  const int kept = ::fcntl(file, F_DUPFD_CLOEXEC, 3);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return kept;
  ::dup2(nowhere, file);
  ::close(nowhere);
  return kept;
}

void giveBack(int kept, int file)
{
  if (kept < 0) return;
  ::dup2(kept, file);
  ::close(kept);
}

void printLine(const std::string& kind, std::string text)
{
  while (!text.empty() && text.back() == '\n') text.pop_back();
  constexpr std::size_t kLongest = 4000;  // of bytes; names of files may have almost as many
  // A progress bar may stand on the line; it is drawn again below.
  const std::string clear = messagesOnTerminal() ? "\r\033[K" : "";
  writeMessage(clear + "mapconv: " + kind + ": " + params::printable(text, kLongest) + "\n");
}

/** Line by line; texts from files may hold anything. */
std::string printableLines(std::string_view text)
{
  std::string lines;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n'))
  {
    lines += params::printable(text.substr(0, end)) + "\n";
    text.remove_prefix(end + 1);
  }
  return lines + params::printable(text);
}
}  // namespace

void writeMessage(const std::string& text)
{
  for (std::string_view left = text; !left.empty();)
  {
    const ssize_t count = ::write(messageFile(), left.data(), left.size());
    if (count < 0 && errno != EINTR) return;  // nobody left to tell
    left.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
  }
}

bool messagesOnTerminal() { return ::isatty(messageFile()) != 0; }

void printError(const std::string& text) { printLine("error", text); }
void printWarning(const std::string& text) { printLine("warning", text); }

void takeWarningsOf(mrpt::system::COutputLogger& log, const std::function<bool()>& wanted)
{
  log.logging_enable_console_output = false;
  log.logRegisterCallback(
      [wanted](std::string_view text, mrpt::system::VerbosityLevel level, std::string_view,
               mrpt::Clock::time_point)
      {
        if (level >= mrpt::system::LVL_WARN && (!wanted || wanted()))
          printWarning(std::string(text));
      });
}

ConsoleLog::ConsoleLog() : mrpt::system::COutputLogger("mapconv") { takeWarningsOf(*this); }

ResultOutput::ResultOutput()
{
  flushAll();
  m_stdout = takeOver(STDOUT_FILENO);
  messageFile() = takeOver(STDERR_FILENO);
}

ResultOutput::~ResultOutput()
{
  flushAll();
  giveBack(m_stdout, STDOUT_FILENO);
  giveBack(std::exchange(messageFile(), STDERR_FILENO), STDERR_FILENO);
}

void ResultOutput::print(const std::string& text)
{
  const std::string shown = printableLines(text);
  for (std::string_view left = shown; !left.empty();)
  {
    const ssize_t count = ::write(m_stdout, left.data(), left.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) mrpt_mapconv::files::throwFileError("write to", "stdout", errno);
    left.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace mapconv
