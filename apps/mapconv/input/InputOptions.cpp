#include "input/InputOptions.h"

#include <mrpt_mapconv/voxel/VoxelMapParams.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "input/InputFile.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** Accepts numbers for which `isOk`. \param right what they are */
CLI::Validator numberThat(bool (*isOk)(double), const std::string& right)
{
  return CLI::Validator(
      [isOk, right](std::string& text)
      {
        double value = 0;
        const bool ok = !text.empty() && CLI::detail::lexical_cast(text, value) && isOk(value);
        return ok ? std::string() : "'" + text + "' is not valid: it must be " + right;
      },
      "");
}
}  // namespace

CLI::Validator isPositive()
{
  return numberThat([](double value) { return std::isfinite(value) && value > 0; }, "a number > 0");
}

CLI::Validator isNotNegative()
{
  return numberThat([](double value) { return std::isfinite(value) && value >= 0; },
                    "a number >= 0");
}

CLI::Validator isFinite()
{
  return numberThat([](double value) { return std::isfinite(value); }, "a finite number");
}

CLI::Validator isOnEarth()
{
  constexpr double kFarthest = 1e9;  // beyond, doubles lose what is taken off
  return numberThat([](double value) { return std::abs(value) <= kFarthest; },
                    "a number of -1e9 to 1e9");
}

CLI::Validator isNumber()
{
  return numberThat([](double value) { return !std::isnan(value); }, "a number");
}

void addOutputOptions(CLI::App& app, std::string& dir, bool& json)
{
  app.add_option("-o,--output", dir,
                 "folder for the results, made if needed; files appear all or none")
      ->required()
      ->type_name("DIR");
  app.add_flag("--json", json, "print the summary as one JSON object");
}

void addPoseOptions(CLI::App& app, observation::RawlogOptions& options)
{
  app.add_flag("--static", options.staticSensor,
               "the sensor of the rawlog stood still: needs no poses");
  app.add_option_function<std::string>(
         "--pose-source", [&options](const std::string& label) { options.poseSource = label; },
         "where poses are taken from: a label in the rawlog, or robotPose, odometry or increments; "
         "default: the first of these three that it has, under the label with the most poses")
      ->type_name("LABEL");
  app.add_option("--max-pose-gap", options.maxPoseGap,
                 "a scan between two poses is left out if one is farther from it in time [s], "
                 "default " +
                     params::textOf(options.maxPoseGap))
      ->check(isNotNegative())
      ->type_name("S");
}

void addThreadsOption(CLI::App& app, int& threads)
{
  app.add_option("--threads", threads, "number of threads, default 0 = all cores")
      ->check(CLI::Range(0, 1024).description(""))
      ->type_name("N");
}

void addInputOptions(CLI::App& app, InputOptions& options)
{
  app.add_option("INPUT", options.input.file,
                 std::string("a .bt or .ot of OctoMap, a .simplemap, a .rawlog, a serialized MRPT "
                             "map that holds an octomap, or a cloud of points with times") +
                     kOrStdin)
      ->required()
      ->type_name("");
  addOutputOptions(app, options.outputDir, options.json);
  app.add_option("-c,--config", options.input.iniFile,
                 "options: sections [conversion], [voxelInsertion]")
      ->type_name("FILE.ini");
  app.add_option("--resolution", options.input.resolution,
                 "voxel size where a voxel map is built from scans [m], default " +
                     params::textOf(voxel::VoxelMapParams().resolution))
      ->check(isPositive())
      ->type_name("M");
  addPoseOptions(app, options.input.log);
  addGeoOptions(app, options.input.geo);
  addUnitOption(app, options.input.geo);
  addColumnsOption(app, options.input.columns);
  addTrajectoryOptions(app, options.input.trajectory);
  addThreadsOption(app, options.threads);
}

}  // namespace mapconv
