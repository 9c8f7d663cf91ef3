#include <algorithm>
#include <cctype>
#include <set>

#include "House.h"
#include "SourceFiles.h"

namespace mrpt_mapconv::house
{
namespace fs = std::filesystem;

namespace
{
using Names = std::set<std::string>;

/** What of a folder is not among the names that it may hold. */
void checkEntries(const fs::path& root, const std::string& folder, const Names& allowed,
                  const std::string& right, Complaints& complaints)
{
  for (const std::string& name : namesIn(root / folder))
    if (allowed.count(name) == 0)
      complaints.push_back((fs::path(folder) / name).string() + ": " + right);
}

/** Whether git ignores an entry of the top level, by lines like "/build*" and "/.cache/". */
bool isIgnored(const std::string& name, const std::vector<std::string>& patterns)
{
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern)
                     {
                       if (pattern.back() != '*') return name == pattern;
                       return name.rfind(pattern.substr(0, pattern.size() - 1), 0) == 0;
                     });
}

void checkTopLevel(const fs::path& root, Complaints& complaints)
{
  Names allowed = {"CMakeLists.txt", "README.md", "LICENSE", "mrpt_mapconv",
                   "apps",           "config",    "tests",   "share"};
  const fs::path gitignore = root / ".gitignore";
  const auto ignored =
      allMatches(fs::exists(gitignore) ? textOf(gitignore) : "", "^/?([^/\n]+)/?$");
  for (const std::string& name : namesIn(root))
    if (name.front() == '.' || isIgnored(name, ignored)) allowed.insert(name);
  checkEntries(root, "", allowed, "has no place at the top level", complaints);
}

/** "sample-map" -> "SampleMap.cpp" */
std::string fileOf(const std::string& subcommand)
{
  std::string name;
  bool begins = true;
  for (const char c : subcommand)
  {
    if (c != '-')
      name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '-';
  }
  return name + ".cpp";
}

void checkCommands(const fs::path& root, Complaints& complaints)
{
  const fs::path program = root / "apps/mapconv";
  for (const fs::path& file : sourcesBelow(program))
  {
    const fs::path name = file.lexically_relative(program);
    const auto subcommands = allMatches(textOf(file), "add_subcommand\\(\\s*\"([^\"]*)\"");
    const std::string place = file.lexically_relative(root).string();
    for (const std::string& subcommand : subcommands)
      if (const auto right = fs::path("command") / fileOf(subcommand); name != right)
        complaints.push_back(place + ": subcommand " + subcommand + " belongs into " +
                             right.string());
    if (name.parent_path() == "command" && subcommands.empty() && name != "command/Command.h")
      complaints.push_back(place + ": declares no subcommand");
  }
}

/** Why a file of one of the program's folders may not include another of its files; empty if it
 * may. */
std::string whyNotIncluded(const std::string& folder, const fs::path& include)
{
  static const Floors floors({"output", "input", "experiment", "command"});
  const std::string other = (*include.begin()).string();
  if (!floors.has(other)) return "it is in no folder of the program";
  if (!floors.mayInclude(folder, other)) return folder + " lies below " + other;
  static const Names ofOutput = {"output/Console.h", "output/Json.h", "output/Progress.h"};
  if (folder == "input" && other == "output" && ofOutput.count(include.string()) == 0)
    return "input uses Console, Json and Progress only";
  return {};
}

/** Only main.cpp is above all folders. */
void checkProgramArrows(const fs::path& root, Complaints& complaints)
{
  const fs::path program = root / "apps/mapconv";
  for (const fs::path& file : sourcesBelow(program))
  {
    const fs::path name = file.lexically_relative(program);
    if (name == "main.cpp") continue;
    for (const std::string& include :
         allMatches(textOf(file), "^[ \t]*#[ \t]*include[ \t]*\"([^\"]+)\""))
      if (const auto why = whyNotIncluded((*name.begin()).string(), include); !why.empty())
        complaints.push_back(file.lexically_relative(root).string() + ": includes " + include +
                             ": " + why);
  }
}

/** The names that ini files call our map classes by. */
Names registeredClasses(const fs::path& root)
{
  Names names;
  for (const fs::path& file : sourcesBelow(root / "mrpt_mapconv/src"))
    for (const std::string& name :
         allMatches(textOf(file), "MAP_DEFINITION_REGISTER\\(\\s*\"[^\",]*,([^\"]*)\""))
      names.insert(name);
  return names;
}

void checkConfig(const fs::path& root, const Floors& floors, Complaints& complaints)
{
  Names allowed = registeredClasses(root);
  allowed.insert({"worlds", "experiments"});
  for (const std::string& name : namesIn(root / "config"))
    if (floors.has(name)) allowed.insert(name);
  checkEntries(root, "config", allowed,
               "is neither worlds, experiments, a room nor the name of a registered map class",
               complaints);
}

void checkUnitTests(const fs::path& root, const Floors& floors, Complaints& complaints)
{
  for (const std::string& name : namesIn(root / "tests/unit"))
    if (!floors.has(name) && name != "house")
      complaints.push_back("tests/unit/" + name + ": tests of no room");
}

/** What a test needs of the program's sources is an algorithm, which belongs into the library. */
void checkTestsUseNoProgram(const fs::path& root, Complaints& complaints)
{
  const fs::path tests = root / "tests";
  const auto complain = [&](const fs::path& file)
  {
    complaints.push_back(file.lexically_relative(root).string() +
                         ": takes sources of apps, whose algorithms belong into the library");
  };
  for (const fs::path& file : filesBelow(tests, {"CMakeLists.txt"}))
    if (textOf(file).find("apps/") != std::string::npos) complain(file);
  for (const fs::path& file : sourcesBelow(tests))
    if (!allMatches(textOf(file), "^#include \"([^\"]*apps/[^\"]*)\"").empty()) complain(file);
}
}  // namespace

Complaints complaintsAboutFolders(const fs::path& root, const Floors& floors)
{
  Complaints complaints;
  checkTopLevel(root, complaints);
  checkEntries(root, "apps", {"CMakeLists.txt", "mapconv"}, "is no program of ours", complaints);
  checkEntries(root, "apps/mapconv", {"command", "input", "output", "experiment", "main.cpp"},
               "is none of command, input, output, experiment and main.cpp", complaints);
  checkCommands(root, complaints);
  checkProgramArrows(root, complaints);
  checkConfig(root, floors, complaints);
  checkUnitTests(root, floors, complaints);
  checkTestsUseNoProgram(root, complaints);
  return complaints;
}

}  // namespace mrpt_mapconv::house
