#include "experiment/report/Gnuplot.h"

#include <fcntl.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace mapconv
{
namespace
{
/** A file that is removed in the end. */
class TemporaryFile
{
 public:
  explicit TemporaryFile(const std::string& text)
      : m_path((std::filesystem::temp_directory_path() / "mapconv-XXXXXX").string())
  {
    const int file = mkstemp(m_path.data());
    if (file < 0) throw std::runtime_error("cannot make a temporary file " + m_path);
    close(file);
    mrpt_mapconv::files::writeFile(m_path, text);
  }
  ~TemporaryFile()
  {
    std::error_code ignored;
    std::filesystem::remove(m_path, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return m_path; }

 private:
  std::string m_path;
};

/** What a run wrote on stdout and stderr, into that file. \return its exit status; 127: not there
 */
int runWithOutput(std::string argument, const std::string& output)
{
  std::string name = "gnuplot";
  char* arguments[] = {name.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_TRUNC, 0);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, name.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return 127;
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

void runOrThrow(const std::string& argument)
{
  const TemporaryFile output("");
  const int status = runWithOutput(argument, output.path());
  if (status == 0) return;
  if (status == 127) throw std::runtime_error("gnuplot is not installed (package gnuplot-nox)");
  std::ifstream in(output.path());
  const std::string words(std::istreambuf_iterator<char>(in), {});
  throw std::runtime_error("gnuplot failed: " + words);
}
}  // namespace

void checkGnuplot() { runOrThrow("--version"); }

void runGnuplot(const std::string& script)
{
  const TemporaryFile file(script);
  runOrThrow(file.path());
}

}  // namespace mapconv
