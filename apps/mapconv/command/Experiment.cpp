#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/params/IniText.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "command/Command.h"
#include "experiment/Experiments.h"
#include "experiment/report/Gnuplot.h"
#include "output/Job.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct ExperimentOptions
{
  std::string iniFile, outputDir;
  bool quick = false;
};

struct ExperimentKind
{
  std::string name;  //!< `kind` in section [experiment] of an ini file
  void (*run)(const ExperimentJob&, Report&);
};

const std::vector<ExperimentKind>& kinds()
{
  static const std::vector<ExperimentKind> all = {{"freespace", runFreespaceExperiment},
                                                  {"scanShape", runScanShapeExperiment},
                                                  {"terrain", runTerrainExperiment},
                                                  {"ground", runGroundExperiment}};
  return all;
}

void runByKind(const ExperimentJob& job, Report& report)
{
  std::vector<std::string> names;
  std::string list;
  for (const ExperimentKind& kind : kinds())
  {
    names.push_back(kind.name);
    list += (list.empty() ? "" : " | ") + kind.name;
  }
  params::StrictSection section(job.ini, "experiment");
  int index = -1;
  section.readChoice("kind", names, index);
  if (index < 0) throw std::runtime_error("section 'experiment': kind = " + list + " is missing");
  kinds()[static_cast<std::size_t>(index)].run(job, report);
}

std::string runExperiment(const ExperimentOptions& options, files::OutputDir& out,
                          Progress& progress)
{
  checkGnuplot();  // now, not after minutes of computing
  const mrpt::config::CConfigFileMemory ini(params::readIniText(options.iniFile));
  Report report(out, "Experiment " + options.iniFile);
  report.addText("Made by `mapconv experiment " + options.iniFile +
                 (options.quick ? " --quick" : "") + "`.");
  try
  {
    runByKind({ini, options.iniFile, options.quick, progress}, report);
  }
  catch (const std::runtime_error& error)
  {
    const std::string what = error.what();
    if (what.rfind("section '", 0) == 0) throw std::runtime_error(options.iniFile + ": " + what);
    throw;
  }
  report.write();
  return report.text();
}

int experiment(const ExperimentOptions& options)
{
  Job job;
  std::string text;
  job.write(options.outputDir,
            [&](files::OutputDir& out) { text = runExperiment(options, out, job.progress()); });
  job.print(text);
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addExperiment(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand(
      "experiment", "Runs an experiment on simulated worlds and writes its tables and plots");
  auto options = std::make_shared<ExperimentOptions>();
  sub->add_option("FILE", options->iniFile, "what to do, see config/experiments")
      ->required()
      ->type_name("FILE.ini");
  sub->add_option("-o,--output", options->outputDir,
                  "folder for report.md, tables (.csv), plots and pictures (.png)")
      ->required()
      ->type_name("DIR");
  sub->add_flag("--quick", options->quick, "a few scans and paths only, to see that it works");
  sub->footer("Example:\n  mapconv experiment config/experiments/freespace.ini -o report");
  return {sub, [options] { return experiment(*options); }};
}

}  // namespace mapconv
