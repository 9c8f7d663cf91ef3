#include <mrpt/core/format.h>
#include <mrpt_mapconv/eval/TrueSteps.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/sim/Scenario.h>
#include <mrpt_mapconv/terrain/TerrainFiles.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "command/Command.h"
#include "input/InputFile.h"
#include "input/InputOptions.h"
#include "input/TerrainBuilder.h"
#include "input/TerrainInput.h"
#include "input/TerrainSettings.h"
#include "output/Console.h"
#include "output/Job.h"
#include "output/StepReport.h"
#include "output/Summary.h"
#include "output/TerrainReport.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct TerrainOptions
{
  TerrainRequest input;
  std::string iniFile, outputDir;
  std::string worldFile;  // empty: the truth is not known
  TerrainFlags flags;
  int threads = 0;
  bool json = false;
};

/** What a run has to tell. */
struct TerrainResult
{
  const TerrainBuilder& builder;
  terrain::TerrainLayers layers;
  std::optional<std::vector<eval::StepMatch>> steps;  //!< if the truth is known
};

std::string skippedText(const TerrainFigures& figures)
{
  std::string text;
  for (const auto& [why, count] : figures.skipped)
    text += (text.empty() ? "" : "; ") + std::to_string(count) + ": " + why;
  return text;
}

void requireCells(const TerrainBuilder& builder, const std::string& file)
{
  if (builder.map().cells() > 0) return;
  const std::string why = skippedText(builder.figures());
  throw std::runtime_error(file + ": none of its scans says anything" +
                           (why.empty() ? "" : " (" + why + ")"));
}

void warnOfLosses(const TerrainFigures& figures)
{
  if (const auto skips = figures.skips(); skips > 0)
    printWarning(std::to_string(skips) + " of " +
                 params::counted(skips + figures.scans, "3D scan") + (skips == 1 ? " is" : " are") +
                 " skipped: " + skippedText(figures));
  if (figures.scans2D > 0)
    printWarning(params::counted(figures.scans2D, "2D scan") +
                 (figures.scans2D == 1 ? " is" : " are") + " left out: they see no terrain");
}

/** The sigmas of the pose stand in for what the log does not know. */
void noteUnusedSigmas(const TerrainBuilder& builder, const std::string& file, NoEffect& noEffect)
{
  const TerrainFigures& figures = builder.figures();
  if (figures.withCovariance == figures.scans)
    noEffect.add(builder.settings().poseSigmas, file + " has the covariance of each pose");
}

void writeOutputs(const TerrainResult& result, const grid::GeoReference& reference,
                  files::OutputDir& out, Progress& progress)
{
  const terrain::TerrainMap& map = result.builder.map();
  grid::ExportFormats formats{"layers.tif"};
  formats.pictures = formats.gridMaps = formats.rosMaps = true;
  formats.reference = reference;
  writeTerrainScene(out.path("map.3Dscene"), map, result.layers);
  if (result.steps) files::writeFile(out.path("true_steps.csv"), stepMatchesCsv(*result.steps));
  terrain::exportTerrain(out, map, result.layers, formats,
                         [&](double share) { progress.done(share); });
}

std::string covarianceText(const TerrainFigures& figures)
{
  if (figures.withCovariance == 0) return "of the pose from heightSigma, rollSigma, pitchSigma";
  return mrpt::format("of the pose from the log for %zu of %zu scans", figures.withCovariance,
                      figures.scans);
}

std::string textSummary(const SummaryHead& head, const TerrainResult& result,
                        const Seconds& seconds)
{
  const TerrainBuilder& builder = result.builder;
  const TerrainFigures& figures = builder.figures();
  std::string text = headText(head);
  text += countsText("terrain", countsOf(result.layers.traversability));
  text += countsText(countsOf(builder.map(), result.layers));
  if (result.steps) text += stepMatchesText(*result.steps);
  const std::string changed = changedText(builder.settings());
  if (!changed.empty()) text += "not default  " + changed + "\n";
  text +=
      mrpt::format("inserted     %zu 3D scans with %zu points\n", figures.scans, figures.points);
  text += "covariance   " + covarianceText(figures) + "\n";
  if (figures.beyondLimits > 0)
    text += mrpt::format("left out     %zu points beyond maxRange, minHeight and maxHeight\n",
                         figures.beyondLimits);
  if (figures.outsideWindow > 0)
    text +=
        mrpt::format("left out     %zu points outside the local window\n", figures.outsideWindow);
  if (figures.skips() > 0)
    text += "skipped      " + params::counted(figures.skips(), "scan") + ", see the warning\n";
  return text + secondsText(seconds);
}

std::string jsonSummary(const SummaryHead& head, const TerrainResult& result,
                        const Seconds& seconds)
{
  const TerrainBuilder& builder = result.builder;
  const TerrainFigures& figures = builder.figures();
  JsonObject why;
  for (const auto& [reason, count] : figures.skipped) why.add(reason, count);
  JsonObject json = summaryJson(head, countsOf(result.layers.traversability));
  addCounts(countsOf(builder.map(), result.layers), json);
  if (result.steps) addStepMatches(*result.steps, json);
  json.add("parameters", settingsJson(builder.settings()));
  json.add("scans3D", figures.scans).add("scansWithCovariance", figures.withCovariance);
  json.add("scans2D", figures.scans2D).add("skipped", figures.skips()).add("skippedBecause", why);
  json.add("points", figures.points).add("pointsBeyondLimits", figures.beyondLimits);
  json.add("pointsOutsideWindow", figures.outsideWindow);
  return json.add("seconds", secondsJson(seconds)).text() + "\n";
}

/** The steps on the robot's way through a simulated world, if there is one: those that the map
 * could tell. */
std::vector<eval::TrueStep> trueStepsOf(const std::string& worldFile,
                                        const TerrainSettings& settings)
{
  if (worldFile.empty()) return {};
  const auto scenario = sim::Scenario::load(worldFile);
  return eval::trueSteps(scenario.world, scenario.trajectory,
                         settings.terrain.params.planeTolerance);
}

int mapTerrain(const TerrainOptions& options)
{
  Job job;
  NoEffect noEffect;
  const TerrainSettings settings = readTerrainSettings(options.iniFile, options.flags);
  job.checkOutput(options.outputDir);

  const std::vector<eval::TrueStep> truth = trueStepsOf(options.worldFile, settings);

  const std::string name = shownName(options.input.file);
  const TerrainInput input =
      job.stage("load", [&] { return TerrainInput(options.input, noEffect, job.progress()); });
  TerrainBuilder builder(settings);
  job.stage("insert", "inserting the scans of " + name,
            [&] { input.insertInto(builder, job.progress()); });
  requireCells(builder, name);
  noteUnusedSigmas(builder, name, noEffect);
  noEffect.warn();
  warnOfLosses(builder.figures());
  job.stage("planes", "finding planes", [&] { builder.finish(options.threads); });
  TerrainResult result{builder, job.stage("layers", [&] { return builder.map().layers(); }), {}};
  if (!options.worldFile.empty()) result.steps = eval::matchSteps(truth, builder.map());
  job.write(options.outputDir, [&](files::OutputDir& out)
            { writeOutputs(result, input.reference(), out, job.progress()); });

  const SummaryHead head{name,
                         input.description(),
                         options.outputDir,
                         result.layers.height.frame(),
                         input.reference(),
                         "pictures, scenes and gridmaps"};
  job.print(options.json ? jsonSummary(head, result, job.seconds())
                         : textSummary(head, result, job.seconds()));
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addTerrain(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand(
      "terrain", "Makes an adaptive terrain map of 3D scans or clouds: heights, planes, steps");
  auto options = std::make_shared<TerrainOptions>();
  sub->add_option("INPUT", options->input.file,
                  std::string("a .rawlog or .simplemap with 3D scans, or a cloud of points with "
                              "times") +
                      kOrStdin)
      ->required()
      ->type_name("");
  addOutputOptions(*sub, options->outputDir, options->json);
  sub->add_option("-c,--config", options->iniFile,
                  "options: sections [map], [terrainInsertion], [terrain]")
      ->type_name("FILE.ini");
  options->flags.grid.addTo(*sub, isNumber());
  options->flags.insertion.addTo(*sub, isNumber());
  options->flags.terrain.addTo(*sub, isNumber());
  sub->add_option("--truth", options->worldFile,
                  "the world that was simulated: lists the steps on the robot's way beside the "
                  "true ones")
      ->type_name("WORLD.ini");
  addPoseOptions(*sub, options->input.log);
  addGeoOptions(*sub, options->input.geo);
  addUnitOption(*sub, options->input.geo);
  addColumnsOption(*sub, options->input.columns);
  addTrajectoryOptions(*sub, options->input.trajectory);
  addThreadsOption(*sub, options->threads);
  sub->footer(
      "Example:\n"
      "  mapconv terrain stairs.rawlog -o map --resolution 0.02\n"
      "Cells are squares centred on multiples of the resolution; those in one plane are merged "
      "into\n"
      "leaves. DIR gets layers.tif, a picture of each layer, leaves.png, planes.csv, steps.csv,\n"
      "traversability.gridmap, .pgm and .yaml, and map.3Dscene. The covariance of a pose is taken\n"
      "from the log where it has one. With --truth there is true_steps.csv, too.");
  return {sub, [options] { return mapTerrain(*options); }};
}

}  // namespace mapconv
