#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/grid/RosMap.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "command/Command.h"
#include "input/IniFile.h"
#include "input/InputOptions.h"
#include "output/Console.h"
#include "output/Interruptible.h"
#include "output/Summary.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct ProjectOptions : InputOptions
{
  double zMin = 0, zMax = 0;
};

void writeOutputs(const grid::Layer<float>& layer, const ProjectOptions& options,
                  Interruptible& interruptible)
{
  files::OutputDir out(options.outputDir);
  const auto watch = interruptible.watch(out);
  const grid::PictureStyle style{"Occupancy between z = " + jsonNumber(options.zMin) + " m and " +
                                     jsonNumber(options.zMax) + " m",
                                 "", grid::PictureKind::Occupancy};
  grid::writeGeoTiff(out.path("projection.tif"), {{"projection", &layer}});
  grid::writeGridMap(out.path("projection.gridmap"), layer);
  grid::writeRosMap(out.path("projection.pgm"), out.path("projection.yaml"), "projection.pgm",
                    layer);
  grid::writeLayerPng(out.path("projection.png"), layer, style);
  interruptible.commit();
}

std::string summary(const ProjectOptions& options, const InputMap& input,
                    const grid::Layer<float>& layer, const Seconds& seconds)
{
  const Job job{options.input.file, input.description(), options.outputDir};
  const OccupancyCounts counts = countsOf(layer);
  if (!options.json)
    return headText(job, layer.frame()) + countsText("projection", counts) + secondsText(seconds);
  JsonObject json = summaryJson(job, layer.frame(), counts);
  json.add("zMin", options.zMin).add("zMax", options.zMax);
  return json.add("seconds", secondsJson(seconds)).text() + "\n";
}

int project(const ProjectOptions& options)
{
  if (!(options.zMin < options.zMax))
    throw UsageError("--z-min " + jsonNumber(options.zMin) + " must be below --z-max " +
                     jsonNumber(options.zMax));
  Interruptible interruptible;
  ResultOutput result;
  InputRequest request = options.input;
  request.insertion = readIni(options.iniFile).insertion;
  // Says now, not after minutes of reading, if nothing can be written there.
  static_cast<void>(files::OutputDir(options.outputDir));

  Seconds seconds;
  Stopwatch watch;
  std::optional<Progress> progress(std::in_place);
  const InputMap input(request, *progress);
  seconds.load = watch.lap();
  progress->stage("projecting");
  const auto layer =
      freespace::projectFixed(input.source(), options.zMin, options.zMax, options.threads);
  seconds.convert = watch.lap();
  progress->stage("writing to " + options.outputDir);
  writeOutputs(layer, options, interruptible);
  seconds.write = watch.lap();
  progress.reset();
  result.print(summary(options, input, layer, seconds));
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
  sub->footer(
      "Example:\n  mapconv project building.bt --z-min 0.1 --z-max 1.8 -o maps\n"
      "DIR gets projection.tif, .gridmap, .pgm, .yaml and .png. A cell is occupied if any of its\n"
      "voxels is, else free if any is.");
  return {sub, [options] { return project(*options); }};
}

}  // namespace mapconv
