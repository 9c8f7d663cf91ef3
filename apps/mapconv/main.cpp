#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/params/Require.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "command/Command.h"
#include "output/Console.h"

namespace
{
constexpr int kFailure = 1;
constexpr int kWrongUsage = 2;

/** What --help and --version ask for is no error; the rest is wrong usage, whatever CLI11's own
 * codes say. */
int afterParsing(const CLI::App& app, const CLI::ParseError& error)
{
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);
  std::string text = error.what();
  if (app.get_subcommands().empty() && !app.remaining().empty())
    text = "there is no subcommand or option '" + app.remaining().front() + "'";
  std::string name = app.get_name();
  for (const CLI::App* chosen : app.get_subcommands()) name += " " + chosen->get_name();
  mapconv::printError(text + " (see " + name + " --help)");
  return kWrongUsage;
}

int runChosen(const std::vector<std::pair<CLI::App*, mapconv::Command>>& commands)
{
  try
  {
    for (const auto& [app, run] : commands)
      if (app->parsed()) return run();
    throw mapconv::UsageError("no subcommand");
  }
  catch (const mapconv::UsageError& error)
  {
    mapconv::printError(error.what());
    return kWrongUsage;
  }
  catch (const std::bad_alloc&)
  {
    mapconv::printError("not enough memory");
  }
  catch (const std::exception& error)
  {
    mapconv::printError(mrpt_mapconv::files::withoutStaging(mrpt_mapconv::params::oneLine(error)));
  }
  return kFailure;
}
}  // namespace

int main(int argc, char** argv)
{
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like a full disk
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::vector<std::string> program = mapconv::takeProgram(arguments);
  CLI::App app("Turns voxel maps and 3D scans into 2D maps for aerial and ground robots.",
               "mapconv");
  app.set_version_flag("--version", "mapconv " MRPT_MAPCONV_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Example:\n  mapconv convert building.bt -o maps --max-step 0.1\n"
      "`mapconv SUBCOMMAND --help` says more. Exit status: 0 done, 1 error, 2 wrong usage.");
  const std::vector<std::pair<CLI::App*, mapconv::Command>> commands = {
      mapconv::addConvert(app),   mapconv::addProject(app),  mapconv::addInsert(app),
      mapconv::addTerrain(app),   mapconv::addGround(app),   mapconv::addPlan(app),
      mapconv::addLift(app),      mapconv::addInfo(app),     mapconv::addRun(app, program),
      mapconv::addSampleMap(app), mapconv::addSimulate(app), mapconv::addExperiment(app),
      mapconv::addParams(app)};
  try
  {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
    app.parse(arguments);
  }
  catch (const CLI::ParseError& error)
  {
    return afterParsing(app, error);
  }
  return runChosen(commands);
}
