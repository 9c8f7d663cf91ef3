#include "InputOptions.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace mapconv
{
namespace
{
/** Finite numbers > 0, for lengths. */
CLI::Validator isPositive()
{
  return CLI::Validator(
      [](std::string& text)
      {
        double value = 0;
        const bool ok = !text.empty() && CLI::detail::lexical_cast(text, value) &&
                        std::isfinite(value) && value > 0;
        return ok ? std::string() : "'" + text + "' is not valid: it must be a number > 0";
      },
      "");
}
}  // namespace

CLI::Validator isNotNegative()
{
  return CLI::Validator(
      [](std::string& text)
      {
        double value = 0;
        const bool ok = !text.empty() && CLI::detail::lexical_cast(text, value) &&
                        std::isfinite(value) && value >= 0;
        return ok ? std::string() : "'" + text + "' is not valid: it must be a number >= 0";
      },
      "");
}

CLI::Validator isNumber()
{
  return CLI::Validator(
      [](std::string& text)
      {
        double value = 0;
        const bool ok =
            !text.empty() && CLI::detail::lexical_cast(text, value) && !std::isnan(value);
        return ok ? std::string() : "'" + text + "' is not valid: it must be a number";
      },
      "");
}

void addInputOptions(CLI::App& app, InputOptions& options)
{
  app.add_option("INPUT", options.input.file,
                 "a .bt or .ot of OctoMap, a .simplemap, a .rawlog, or a serialized MRPT map that "
                 "holds an octomap")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", options.outputDir,
                 "folder for the results, made if needed; files appear all or none")
      ->required()
      ->type_name("DIR");
  app.add_option("-c,--config", options.iniFile, "options: sections [conversion], [insertion]")
      ->type_name("FILE.ini");
  app.add_option("--resolution", options.input.resolution,
                 "voxel size where a voxel map is built from scans [m], default 0.1")
      ->check(isPositive())
      ->type_name("M");
  app.add_flag("--static", options.input.staticSensor,
               "the sensor of the rawlog stood still: needs no poses");
  app.add_option("--threads", options.threads, "number of threads, default 0 = all cores")
      ->check(CLI::Range(0, 1024).description(""))
      ->type_name("N");
  app.add_flag("--json", options.json, "print the summary as one JSON object");
}

}  // namespace mapconv
