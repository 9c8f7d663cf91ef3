#include "Gnuplot.h"

#include <mrpt_mapconv/grid/FileIo.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
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
  {
    std::string path = (std::filesystem::temp_directory_path() / "mapconv-XXXXXX").string();
    const int file = mkstemp(path.data());
    if (file < 0) throw std::runtime_error("cannot make a temporary file " + path);
    std::fclose(fdopen(file, "w"));
    m_path = path;
    mrpt_mapconv::grid::writeFile(m_path, text);
  }
  ~TemporaryFile() { std::remove(m_path.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return m_path; }

 private:
  std::string m_path;
};
}  // namespace

void runGnuplot(const std::string& script)
{
  const TemporaryFile file(script);
  const std::string command = "gnuplot '" + file.path() + "' 2>&1 </dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot start gnuplot");
  std::string words;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), part.size(), pipe)) words += part.data();
  const int status = pclose(pipe);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    throw std::runtime_error("gnuplot is not installed (package gnuplot-nox)");
  throw std::runtime_error("gnuplot failed: " + words);
}

}  // namespace mapconv
