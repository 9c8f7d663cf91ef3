#include "Program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "support/TempDir.h"

namespace mrpt_mapconv::testing
{
namespace
{
[[noreturn]] void become(const std::vector<std::string>& command, const std::string& out,
                         const std::string& err)
{
  const int outFile = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const int errFile = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  ::dup2(outFile, STDOUT_FILENO);
  ::dup2(errFile, STDERR_FILENO);
  std::vector<std::string> words = command;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execvp(argv[0], argv.data());
  ::_exit(126);
}
}  // namespace

Outcome runProgram(const std::vector<std::string>& command, const std::string& stdoutFile)
{
  const TempDir folder;
  const std::string out = stdoutFile.empty() ? folder.path("out") : stdoutFile;
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) become(command, out, folder.path("err"));
  int status = 0;
  ::waitpid(child, &status, 0);
  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (stdoutFile.empty()) outcome.out = readBytes(out);
  std::istringstream lines(readBytes(folder.path("err")));
  for (std::string line; std::getline(lines, line);)
    (line.compare(0, 19, "mapconv: progress: ") == 0 ? outcome.progress : outcome.err) +=
        line + (lines.eof() ? "" : "\n");
  return outcome;
}

Outcome mapconv(std::vector<std::string> arguments, const std::string& stdoutFile)
{
  arguments.insert(arguments.begin(), MAPCONV_PROGRAM);
  return runProgram(arguments, stdoutFile);
}

bool isOneError(const std::string& text)
{
  const std::string begin = "mapconv: error: ";
  return text.compare(0, begin.size(), begin) == 0 && text.size() > begin.size() + 1 &&
         std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

int warningsIn(const std::string& text)
{
  std::istringstream lines(text);
  int count = 0;
  for (std::string line; std::getline(lines, line);)
    count += line.compare(0, 18, "mapconv: warning: ") == 0;
  return count;
}

}  // namespace mrpt_mapconv::testing
