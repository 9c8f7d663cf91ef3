#include <mrpt/core/format.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/DropEdges.h>
#include <mrpt_mapconv/freespace/LayerFiles.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/params/Text.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "command/Command.h"
#include "input/IniFile.h"
#include "input/InputFile.h"
#include "input/InputOptions.h"
#include "output/Console.h"
#include "output/FreeSpaceAdvice.h"
#include "output/Job.h"
#include "output/Scene.h"
#include "output/Summary.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using freespace::ConversionParams;

namespace
{
struct ConvertOptions : InputOptions
{
  FieldFlags<ConversionParams> flags;
};

void writeOutputs(const freespace::Layers& layers, const ConversionParams& params,
                  const InputMap& input, files::OutputDir& out, Progress& progress)
{
  grid::ExportFormats formats{"layers.tif", freespace::metadataOf(params)};
  formats.pictures = formats.gridMaps = formats.rosMaps = true;
  formats.reference = input.reference();
  input.writeOctree(out.path("voxels.bt"));
  constexpr double kLayersShare = 0.9;
  const auto edges = freespace::dropEdges(layers, params);
  grid::exportLayers(out, layers.styled(edges), formats,
                     [&](double share) { progress.done(kLayersShare * share); });
  writeScene(out.path("map.3Dscene"), layers, params);
  progress.done(1);
}

/** A map in which nothing could be free but by --unknown is no map to plan on. */
void requireFreeVoxel(const InputMap& input, const ConvertOptions& options,
                      const ConversionParams& params)
{
  if (params.reading.unknown == voxel::Unknown::Unknown && !voxel::hasFreeVoxel(input.source()))
    throw std::runtime_error(shownName(options.input.file) + ": " + kNoFreeVoxel);
}

void warnAbout(const freespace::LayerStatistics& counts, const ConversionParams& params,
               double resolution)
{
  if (counts.free == 0)
    printWarning("nowhere are minClearance = " + jsonNumber(params.minClearance) +
                 " m of free space above each other, so all layers are unknown; a smaller "
                 "--min-clearance finds lower free space");
  if (2 * counts.frontier > counts.free)
    printWarning(
        "under most of the free cells nobody saw the ground (frontier), so they are unknown to a "
        "ground robot; for maps of few scans --floor-from lowestFree takes the lowest free voxel "
        "for it, seen or not");
  constexpr double kHighStep = 0.3;
  const double minStep = params.minStep(resolution);
  if (minStep > kHighStep && !params.looksForSteps())
    printWarning(
        mrpt::format("the slope test marks straight steps for the ground robot only from "
                     "minStep = %.2f m on, and walls one cell thick from minThinWall = %.2f m on; "
                     "--max-step %.2g, say, also marks lower ones",
                     minStep, params.minThinWall(resolution), std::max(0.1, 1.5 * resolution)));
}

/** Those of some names that are among the keys. */
std::vector<std::string> amongst(const std::vector<std::string>& keys,
                                 std::vector<std::string> names)
{
  const auto isMissing = [&keys](const std::string& name)
  { return std::find(keys.begin(), keys.end(), name) == keys.end(); };
  names.erase(std::remove_if(names.begin(), names.end(), isMissing), names.end());
  return names;
}

OccupancyCounts groundCounts(const freespace::LayerStatistics& counts)
{
  return {counts.groundFree, counts.groundOccupied, counts.groundUnknown};
}

std::string jsonSummary(const SummaryHead& head, const freespace::LayerStatistics& counts,
                        const ConversionParams& params, const Seconds& seconds)
{
  JsonObject json = summaryJson(head, {counts.free, counts.occupied, counts.unknown});
  const OccupancyCounts ground = groundCounts(counts);
  json.add("groundFree", ground.free).add("groundOccupied", ground.occupied);
  json.add("groundUnknown", ground.unknown);
  json.add("steep", counts.steep).add("slopeUnknown", counts.slopeUnknown);
  json.add("inferred", counts.inferred).add("frontier", counts.frontier);
  JsonObject parameters;
  addFields(params, parameters);
  const double resolution = head.frame.resolution;
  json.add("minStep", params.minStep(resolution));
  json.add("minThinWall", params.minThinWall(resolution)).add("parameters", parameters);
  return json.add("seconds", secondsJson(seconds)).text() + "\n";
}

std::string textSummary(const SummaryHead& head, const freespace::LayerStatistics& counts,
                        const ConversionParams& params, const Seconds& seconds)
{
  std::string text = headText(head);
  text += countsText("aerial", {counts.free, counts.occupied, counts.unknown});
  text += countsText("ground", groundCounts(counts));
  text += mrpt::format(
      "             of the free cells of aerial %zu are too steep, a step or an edge (steep)\n",
      counts.steep);
  if (params.floorFrom == freespace::FloorFrom::Seen)
    text += mrpt::format(
        "evidence     of the free cells %zu have ground that is inferred, not seen (inferred), "
        "and\n"
        "             %zu have ground that is not known (frontier)\n",
        counts.inferred, counts.frontier);
  else
    text += mrpt::format("             and %zu have no known slope (slopeUnknown)\n",
                         counts.slopeUnknown);
  text += mrpt::format(
      "minStep      %.2f m: lowest straight step that the slope test marks\n"
      "minThinWall  %.2f m: lowest wall one cell thick that it marks, on either side; single posts "
      "hardly ever; ",
      params.minStep(head.frame.resolution), params.minThinWall(head.frame.resolution));
  text += params.looksForSteps()
              ? "maxStep marks those above " +
                    mrpt_mapconv::params::roundedText(params.stepHeight(head.frame.resolution)) +
                    " m\n"
              : std::string("maxStep is off\n");
  return text + secondsText(seconds);
}

int convert(const ConvertOptions& options)
{
  Job job;
  const IniOptions ini = readIni(options.input.iniFile, options.flags);
  const ConversionParams& params = ini.conversion.params;
  InputRequest request = options.input;
  request.insertion = ini.insertion;
  request.threads = options.threads;
  request.insertionKeys = ini.insertionKeys;
  const auto& keys = ini.conversionKeys;
  request.noEffect.addKeys(amongst(keys, {"robot"}), request.iniFile,
                           "convert makes layers for both");
  if (params.floorFrom == freespace::FloorFrom::LowestFree)
    request.noEffect.addKeys(amongst(keys, {"maxGap", "maxHiddenGap"}), request.iniFile,
                             "floorFrom is lowestFree");
  job.checkOutput(options.outputDir);

  const InputMap input = job.stage("load", [&] { return InputMap(request, job.progress()); });
  const freespace::Layers layers =
      job.stage("convert", "converting",
                [&] { return freespace::convert(input.source(), params, options.threads); });
  const auto counts = freespace::statistics(layers);
  if (counts.free == 0) requireFreeVoxel(input, options, params);
  warnAbout(counts, params, layers.frame().resolution);
  job.write(options.outputDir, [&](files::OutputDir& out)
            { writeOutputs(layers, params, input, out, job.progress()); });

  const SummaryHead head{shownName(options.input.file),
                         input.description(),
                         options.outputDir,
                         layers.frame(),
                         input.reference(),
                         "pictures, scenes, gridmaps and voxels.bt"};
  job.print(options.json ? jsonSummary(head, counts, params, job.seconds())
                         : textSummary(head, counts, params, job.seconds()));
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addConvert(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand(
      "convert",
      "Makes floor, ceiling, slope and occupancy layers of a voxel map by free-space projection");
  auto options = std::make_shared<ConvertOptions>();
  addInputOptions(*sub, *options);
  options->flags.addTo(*sub);
  sub->footer(
      "Example:\n"
      "  mapconv convert building.bt -o maps --min-clearance 0.5 --max-step 0.1\n"
      "  mapconv convert drive.rawlog -o maps --resolution 0.2 -c convert.ini\n"
      "DIR gets layers.tif; voxels.bt; aerial and ground .gridmap, .pgm and .yaml; a .png of each\n"
      "layer; map.3Dscene. It is what plan and lift work on. In the summary free, occupied and\n"
      "unknown count cells of the aerial layer. Of the free ones steep are occupied for a ground\n"
      "robot, frontier are unknown to it, since nobody saw the ground, and inferred have ground\n"
      "that was not seen itself, but around.");
  return {sub, [options] { return convert(*options); }};
}

}  // namespace mapconv
