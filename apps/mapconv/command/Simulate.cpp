#include <mrpt/core/format.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/sim/SimulationFiles.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "command/Command.h"
#include "output/Job.h"
#include "output/Json.h"
#include "output/Summary.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct SimulateOptions
{
  std::string worldFile, outputDir;
  std::vector<std::string> sensors;  // all that are not spare if empty
  std::uint64_t seed = 1;
  bool json = false;
};

/** Decimal digits and nothing else: CLI11 itself takes -1 for 2^64 - 1 and 010 for 8. */
std::uint64_t seedOf(const std::string& text)
{
  std::uint64_t seed = 0;
  if (!params::readWhole(text, seed))
    throw CLI::ValidationError(
        "--seed", "'" + text + "' is not valid: it must be a whole number from 0 to 2^64 - 1");
  return seed;
}

std::string summaryText(const SimulateOptions& options, const sim::SimulationSummary& summary,
                        double seconds)
{
  if (!options.json)
    return fromTo(options.worldFile, options.outputDir) +
           mrpt::format(
               "run          %.1f s, %.1f m, %zu scans, %zu key frames, %zu 3D returns\n"
               "seconds      %.1f\n",
               summary.seconds, summary.way, summary.scans, summary.keyFrames, summary.returns3D,
               seconds);
  JsonObject json;
  json.add("world", options.worldFile).add("output", options.outputDir).add("seed", options.seed);
  json.add("duration", summary.seconds).add("way", summary.way).add("scans", summary.scans);
  json.add("keyFrames", summary.keyFrames).add("returns3D", summary.returns3D);
  return json.add("seconds", seconds).text() + "\n";
}

int simulate(const SimulateOptions& options)
{
  Job job;
  Stopwatch stopwatch;
  const auto scenario =
      job.stage("load", "reading " + options.worldFile,
                [&] { return sim::Scenario::load(options.worldFile, options.sensors); });
  sim::SimulationSummary summary;
  job.write(options.outputDir,
            [&](files::OutputDir& out)
            {
              job.progress().stage("simulating");
              summary = sim::simulateTo(out, scenario, options.seed,
                                        [&](double share) { job.progress().done(share); });
            });
  job.print(summaryText(options, summary, stopwatch.lap()));
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addSimulate(CLI::App& app)
{
  CLI::App* sub =
      app.add_subcommand("simulate", "Lets a robot drive through a world whose truth is known");
  auto options = std::make_shared<SimulateOptions>();
  sub->add_option("WORLD", options->worldFile, "the world, its sensors and the robot's way")
      ->required()
      ->type_name("WORLD.ini");
  sub->add_option("-o,--output", options->outputDir, "folder for logs and truth, made if needed")
      ->required()
      ->type_name("DIR");
  sub->add_option_function<std::string>(
         "--seed", [options](const std::string& text) { options->seed = seedOf(text); },
         "for all that is random, default 1; the same seed gives the same files")
      ->type_name("N");
  sub->add_option("--sensor", options->sensors,
                  "the sensor that the robot has, may be given several times; default: all that "
                  "are not spare")
      ->type_name("NAME")
      ->allow_extra_args(false);
  sub->add_flag("--json", options->json, "print the summary as one JSON object");
  sub->footer(
      "Example:\n  mapconv simulate config/worlds/building.ini -o building\n"
      "DIR gets scans.rawlog (observations), frames.rawlog (actions and sensory frames),\n"
      "scans.simplemap, trajectory.csv (the true way), truth.tif and a .png of each true layer.\n"
      "What WORLD.ini may hold: see share/doc/worlds.md");
  return {sub, [options] { return simulate(*options); }};
}

}  // namespace mapconv
