#include <dlfcn.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "command/Command.h"
#include "input/MapCounts.h"

namespace mapconv
{
namespace
{
/** The library that this program itself runs with. */
std::string libraryPath()
{
  Dl_info info{};
  const auto* symbol = reinterpret_cast<const void*>(&mrpt_mapconv::freespace::frameOf);
  if (::dladdr(symbol, &info) == 0 || !info.dli_fname)
    throw std::runtime_error("cannot find out where libmrpt_mapconv.so lies");
  return std::filesystem::canonical(info.dli_fname).string();
}

/** Puts a word in front of a list of the environment that colons separate. */
void putInFront(const char* variable, const std::string& word)
{
  const char* others = std::getenv(variable);
  ::setenv(variable, (others && *others ? word + ":" + others : word).c_str(), 1);
}

void preload(const std::string& library)
{
  if (library.find(':') != std::string::npos)
    throw std::runtime_error("'" + library + "' cannot be preloaded: its path holds a colon");
  if (library.find(' ') == std::string::npos)
  {
    putInFront("LD_PRELOAD", library);
    return;
  }
  // A space ends a name in LD_PRELOAD, but not in LD_LIBRARY_PATH.
  const std::filesystem::path path(library);
  putInFront("LD_LIBRARY_PATH", path.parent_path().string());
  putInFront("LD_PRELOAD", path.filename().string());
}

int run(std::vector<std::string> words)
{
  if (words.empty()) throw UsageError("run: which program? (see mapconv run --help)");
  for (const std::string& word : words)
    if (word.size() > 4 && word.compare(word.size() - 4, 4, ".ini") == 0) warnUnknownMaps(word);
  preload(libraryPath());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execvp(argv[0], argv.data());
  throw std::runtime_error("cannot run '" + words.front() +
                           "': " + std::generic_category().message(errno));
}
}  // namespace

std::vector<std::string> takeProgram(std::vector<std::string>& arguments)
{
  if (arguments.empty() || arguments.front() != "run" || arguments.size() < 2) return {};
  auto begin = arguments.begin() + 1;
  const bool option =
      !begin->empty() && begin->front() == '-' && *begin != "--";  // one of ours: --help
  if (option) return {};
  std::vector<std::string> program(*begin == "--" ? begin + 1 : begin, arguments.end());
  arguments.erase(begin, arguments.end());
  return program;
}

std::pair<CLI::App*, Command> addRun(CLI::App& app, std::vector<std::string> program)
{
  CLI::App* sub = app.add_subcommand(
      "run",
      "Runs an MRPT program with this library's map classes loaded; its exit status is ours");
  sub->footer(
      "Usage and example:\n  mapconv run -- PROGRAM ARGS...\n"
      "  mapconv run -- observations2map config.ini map.simplemap out\n"
      "The library is put in front of LD_PRELOAD.");
  return {sub, [program = std::move(program)] { return run(program); }};
}

}  // namespace mapconv
