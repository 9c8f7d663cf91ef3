#pragma once

#include <mrpt/system/COutputLogger.h>

#include <functional>
#include <string>

namespace mapconv
{
/** Prints "mapconv: error: …" as one line on stderr, in which everything can be shown. */
void printError(const std::string& text);
/** Prints "mapconv: warning: …" as one line on stderr. */
void printWarning(const std::string& text);

/** Makes a logger's warnings ours, and its own console output silent.
 * \param wanted asked at each warning whether it is to be printed; none: all are */
void takeWarningsOf(mrpt::system::COutputLogger& log, const std::function<bool()>& wanted = {});

/** Where the library logs to: its warnings become ours. */
class ConsoleLog : public mrpt::system::COutputLogger
{
 public:
  ConsoleLog();
};

/** Writes on the real stderr as it is, e.g. a progress bar. */
void writeMessage(const std::string& text);
/** Whether that is a terminal. */
bool messagesOnTerminal();

/** Keeps stdout for the program's result and stderr for its messages: while this object lives,
 * whatever libraries print is dropped, so that `--json` gives one JSON object and an error is one
 * line. (OctoMap tells of every tree it reads, libpng of what we report ourselves; what matters
 * comes as an exception or by way of ConsoleLog.) */
class ResultOutput
{
 public:
  ResultOutput();
  ~ResultOutput();
  ResultOutput(const ResultOutput&) = delete;
  ResultOutput& operator=(const ResultOutput&) = delete;

  /** Prints on the real stdout; what a terminal would not show stands there as \xNN.
   * \exception std::runtime_error with the system's reason, e.g. on a full disk */
  void print(const std::string& text);

 private:
  int m_stdout;
};

}  // namespace mapconv
