#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "Golden.h"
#include "Program.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

// Scripts use these flags. What --help says about them may change, and there may be more
// subcommands than golden/help_flags.txt lists: one gets into that file by a line with its name.

namespace
{
const std::string kFile = "help_flags.txt";

/** The subcommands that the golden file has, in its order; "mapconv" is the program itself. */
std::vector<std::string> listedSubcommands()
{
  std::istringstream lines(readBytes(goldenPath(kFile)));
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);)
    if (const auto name = line.substr(0, line.find(' ')); names.empty() || names.back() != name)
      names.push_back(name);
  return names;
}

/** "-o,--output DIR REQUIRED" of "  -o,--output DIR REQUIRED   where to"; a default like "M=1" or
 * "M [1]" is left out. */
std::set<std::string> flagsIn(const std::string& help)
{
  static const std::regex option("^ {2}(-\\S+(?: \\S+)*)");
  static const std::regex defaultValue("(=\\S*| \\[[^\\]]*\\])");
  std::set<std::string> flags;
  std::istringstream lines(help);
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, found, option))
      flags.insert(std::regex_replace(found.str(1), defaultValue, ""));
  return flags;
}

std::string flagsOf(const std::string& subcommand)
{
  std::vector<std::string> arguments = {subcommand, "--help"};
  if (subcommand == "mapconv") arguments.erase(arguments.begin());
  const auto run = mapconv(arguments);
  EXPECT_EQ(0, run.status) << subcommand << ": " << run.err;
  std::string text;
  for (const auto& flag : flagsIn(run.out)) text += subcommand + " " + flag + "\n";
  return text;
}
}  // namespace

TEST(GoldenHelp, everySubcommandHasItsFlags)
{
  const auto subcommands = listedSubcommands();
  ASSERT_LE(12u, subcommands.size());
  std::string text;
  for (const auto& subcommand : subcommands) text += flagsOf(subcommand);
  expectGolden(kFile, text);
}
