#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/voxel/UnknownVoxels.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "command/Command.h"
#include "input/IniFile.h"
#include "input/InputFile.h"
#include "input/InputOptions.h"
#include "output/Console.h"
#include "output/FreeSpaceAdvice.h"
#include "output/Job.h"
#include "output/Summary.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct ProjectOptions : InputOptions
{
  double zMin = 0, zMax = 0;
  FieldFlags<voxel::ReadingParams> flags;
};

/** What the options ask for; what has no effect on a projection is noted. */
InputRequest requestOf(const ProjectOptions& options, const IniOptions& ini)
{
  InputRequest request = options.input;
  request.insertion = ini.insertion;
  request.threads = options.threads;
  request.insertionKeys = ini.insertionKeys;
  auto keys = ini.conversionKeys;
  const auto isUsed = [](const std::string& key)
  { return params::hasField<voxel::ReadingParams>(key); };
  keys.erase(std::remove_if(keys.begin(), keys.end(), isUsed), keys.end());
  request.noEffect.addKeys(keys, request.iniFile, "project looks at nothing but heights");
  return request;
}

void writeOutputs(const grid::Layer<float>& layer, const grid::GeoReference& reference,
                  const ProjectOptions& options, files::OutputDir& out)
{
  const std::string title = "Occupancy between z = " + jsonNumber(options.zMin) + " m and " +
                            jsonNumber(options.zMax) + " m";
  grid::ExportFormats formats{"projection.tif"};
  formats.pictures = formats.gridMaps = formats.rosMaps = true;
  formats.reference = reference;
  grid::exportLayers(out, {{"projection", &layer, title, "", grid::LayerKind::Occupancy}}, formats);
}

std::string summary(const ProjectOptions& options, const InputMap& input,
                    const grid::Layer<float>& layer, const Seconds& seconds)
{
  const SummaryHead head{shownName(options.input.file),
                         input.description(),
                         options.outputDir,
                         layer.frame(),
                         input.reference(),
                         "pictures and gridmaps"};
  const OccupancyCounts counts = countsOf(layer);
  if (!options.json)
    return headText(head) + countsText("projection", counts) + secondsText(seconds);
  JsonObject json = summaryJson(head, counts);
  json.add("zMin", options.zMin).add("zMax", options.zMax);
  return json.add("seconds", secondsJson(seconds)).text() + "\n";
}

int project(const ProjectOptions& options)
{
  if (!(options.zMin < options.zMax))
    throw UsageError("--z-min " + jsonNumber(options.zMin) + " must be below --z-max " +
                     jsonNumber(options.zMax));
  Job job;
  const IniOptions ini = readIni(options.input.iniFile);
  voxel::ReadingParams reading = ini.conversion.params.reading;
  options.flags.applyTo(reading);
  const InputRequest request = requestOf(options, ini);
  job.checkOutput(options.outputDir);

  const InputMap input = job.stage("load", [&] { return InputMap(request, job.progress()); });
  const auto layer =
      job.stage("convert", "projecting",
                [&]
                {
                  return freespace::projectFixed(voxel::FilledSource(input.source(), reading),
                                                 options.zMin, options.zMax, options.threads);
                });
  if (countsOf(layer).free == 0 && reading.unknown == voxel::Unknown::Unknown &&
      !voxel::hasFreeVoxel(input.source()))
    printWarning(shownName(options.input.file) + ": " + kNoFreeVoxel);
  job.write(options.outputDir,
            [&](files::OutputDir& out) { writeOutputs(layer, input.reference(), options, out); });
  job.print(summary(options, input, layer, job.seconds()));
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addProject(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand(
      "project",
      "Makes one occupancy layer of the voxels between two heights, as OctoMap's server");
  auto options = std::make_shared<ProjectOptions>();
  addInputOptions(*sub, *options);
  sub->add_option("--z-min", options->zMin, "voxels must reach above this height [m]")
      ->required()
      ->check(isNumber())
      ->type_name("M");
  sub->add_option("--z-max", options->zMax, "voxels must begin below this height [m]")
      ->required()
      ->check(isNumber())
      ->type_name("M");
  options->flags.addTo(*sub);
  sub->footer(
      "Example:\n  mapconv project building.bt --z-min 0.1 --z-max 1.8 -o maps\n"
      "DIR gets projection.tif, .gridmap, .pgm, .yaml and .png. A cell is occupied if any of its\n"
      "voxels is, else free if any is.");
  return {sub, [options] { return project(*options); }};
}

}  // namespace mapconv
