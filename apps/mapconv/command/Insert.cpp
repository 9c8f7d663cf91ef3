#include <mrpt/core/format.h>
#include <mrpt_mapconv/files/ObjectWriter.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/KnownFrame.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/scan/ProfileSummary.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "command/Command.h"
#include "input/EachScan.h"
#include "input/GeoOptions.h"
#include "input/InputFile.h"
#include "input/InputOptions.h"
#include "input/ScanFile.h"
#include "input/ScanInserter.h"
#include "input/ScanSettings.h"
#include "output/Console.h"
#include "output/Job.h"
#include "output/Summary.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct InsertOptions
{
  std::string file, iniFile, outputDir;
  ScanFlags flags;
  observation::RawlogOptions log;
  GeoOptions geo;
  bool json = false;
};

/** The map without the room that it has left for further scans. */
struct Result
{
  grid::Layer<float> occupancy, probability;  //!< on the same frame
};

std::string skippedText(const InsertionFigures& figures)
{
  std::string text;
  for (const auto& [kind, skipped] : figures.skipped)
    text += (text.empty() ? "" : "; ") + std::to_string(skipped.count) + ": " + skipped.why;
  return text;
}

/** The same for the summary, which does not repeat a warning. */
std::string skippedLine(const InsertionFigures& figures)
{
  if (figures.unwantedSkips() == 0) return skippedText(figures);
  return params::counted(figures.skips(), "scan") + ", see the warning";
}

Result resultOf(const ScanInserter& inserter, const std::string& file)
{
  const auto occupancy = inserter.map().occupancy();
  const grid::GridFrame frame = grid::knownFrame(occupancy, grid::LayerKind::Occupancy);
  if (frame.empty())
    throw std::runtime_error(file + ": none of its scans says anything (" +
                             skippedText(inserter.figures()) + ")");
  return {occupancy.onFrame(frame, grid::kUnknown), inserter.map().probability().onFrame(frame, 0)};
}

void warnOfSkips(const InsertionFigures& figures)
{
  if (figures.unwantedSkips() == 0) return;
  const std::size_t all = figures.skips() + figures.scans2D + figures.scans3D;
  printWarning(std::to_string(figures.skips()) + " of " + params::counted(all, "scan") +
               (figures.skips() == 1 ? " is" : " are") + " skipped: " + skippedText(figures));
}

/** Where the ceiling passes for walls in most scans, the rest is no map. */
void refuseCeilings(const InsertionFigures& figures, const std::string& file)
{
  const auto ceilings = figures.skipped.find(CScanShapeGridMap2D::kCeilingSkip);
  if (ceilings == figures.skipped.end() || ceilings->second.count <= figures.scans3D) return;
  throw std::runtime_error(file + ": in " + std::to_string(ceilings->second.count) +
                           " of its 3D scans " + ceilings->second.why + " (--structure MIN MAX)");
}

/** A 2D scanner looks below table tops and into glass, and takes back what 3D scans have found. */
void warnOf2D(const InsertionFigures& figures)
{
  if (figures.scans2D == 0) return;
  printWarning(params::counted(figures.scans2D, "2D scan") + " inserted as well: " +
               "cells whose objects lie above or below such a scan become free, and nothing cuts "
               "reflections; --no-2d (or insert2D = false in section [scanInsertion] of an ini "
               "file) leaves them out");
}

/** As MRPT's own class, which its programs read without this library; with the map's own cells. */
void writeGrid(const std::string& path, const CScanShapeGridMap2D& map,
               const grid::Layer<float>& occupancy)
{
  const grid::GridFrame from = map.frame(), to = occupancy.frame();
  mrpt::maps::COccupancyGridMap2D plain;
  grid::copyToGridMap(occupancy, plain);
  for (std::int32_t iy = 0; iy < to.height; ++iy)
    std::copy_n(map.getRow(iy + to.y0 - from.y0) + (to.x0 - from.x0), to.width, plain.getRow(iy));
  files::writeObject(path, plain);
}

std::string titleOf(const scan::ProfileParams& params)
{
  return "Occupancy between z = " + jsonNumber(params.objectMinZ) + " m and " +
         jsonNumber(params.objectMaxZ) + " m, from 3D scans";
}

void writeOutputs(const Result& map, const ScanInserter& inserter,
                  const grid::GeoReference& reference, files::OutputDir& out)
{
  grid::ExportFormats formats;
  formats.pictures = formats.rosMaps = true;
  formats.reference = reference;
  const auto title = titleOf(inserter.settings().insertion.profile);
  grid::ExportFormats tiff{"map.tif"};
  tiff.reference = reference;
  grid::exportLayers(out, {{"occupancy", &map.probability}}, tiff);
  grid::exportLayers(out, {{"map", &map.occupancy, title, "", grid::LayerKind::Occupancy}},
                     formats);
  writeGrid(out.path("map.gridmap"), inserter.map(), map.occupancy);
}

std::string textSummary(const SummaryHead& head, const Result& map, const ScanInserter& inserter,
                        const Seconds& seconds)
{
  const auto& params = inserter.settings().insertion.profile;
  const InsertionFigures& figures = inserter.figures();
  std::string text = headText(head);
  text += countsText("map", countsOf(map.occupancy));
  text += "model        " + scan::summaryOf(params) + "\n";
  const std::string changed = changedText(inserter.settings());
  if (!changed.empty()) text += "not default  " + changed + "\n";
  text += mrpt::format("inserted     %zu 3D scans with %zu points, %zu 2D scans\n", figures.scans3D,
                       figures.points, figures.scans2D);
  if (figures.skips() > 0) text += "skipped      " + skippedLine(figures) + "\n";
  if (params.reflectionFilter)
    text += mrpt::format("walls        on %.1f %% of the azimuths, mean of the 3D scans\n",
                         100 * figures.meanWallShare());
  text += mrpt::format(
      "speed        %.1f 3D scans/s, %.2f million points/s of insertion, decoding included\n",
      figures.scansPerSecond(), 1e-6 * figures.pointsPerSecond());
  return text + secondsText(seconds);
}

std::string jsonSummary(const SummaryHead& head, const Result& map, const ScanInserter& inserter,
                        const Seconds& seconds)
{
  const InsertionFigures& figures = inserter.figures();
  JsonObject why;
  for (const auto& [kind, skipped] : figures.skipped) why.add(skipped.why, skipped.count);
  JsonObject json = summaryJson(head, countsOf(map.occupancy));
  json.add("parameters", settingsJson(inserter.settings()));
  json.add("scans3D", figures.scans3D).add("scans2D", figures.scans2D);
  json.add("skipped", figures.skips()).add("skippedBecause", why).add("points", figures.points);
  // null: walls were not looked for
  const bool filter = inserter.settings().insertion.profile.reflectionFilter;
  json.add("shareWithWall", filter ? figures.meanWallShare() : NAN);
  json.add("scansPerSecond", figures.scansPerSecond());
  json.add("pointsPerSecond", figures.pointsPerSecond());
  return json.add("seconds", secondsJson(seconds)).text() + "\n";
}

int insert(const InsertOptions& options)
{
  Job job;
  NoEffect noEffect;
  const ScanSettings settings = readScanSettings(options.iniFile, options.flags, noEffect);
  job.checkOutput(options.outputDir);

  ScanFile file = job.stage(
      "load", [&] { return read3DScans(options.file, options.log, noEffect, job.progress()); });
  const auto reference = moveToOrigin(file.scans, shownName(options.file), options.geo, 0);
  noEffect.warn();
  requireStructure(settings);
  ScanInserter inserter(settings);
  const std::string name = shownName(options.file);
  job.stage("insert", "inserting the scans of " + name,
            [&]
            {
              forEachScan(file.scans, name, job.progress(),
                          [&](const auto& scan) { inserter.insert(scan); });
            });
  warnOf2D(inserter.figures());
  refuseCeilings(inserter.figures(), name);
  const Result map = resultOf(inserter, name);
  warnOfSkips(inserter.figures());
  job.write(options.outputDir,
            [&](files::OutputDir& out) { writeOutputs(map, inserter, reference, out); });

  const SummaryHead head{shownName(options.file), file.description, options.outputDir,
                         map.occupancy.frame(),   reference,        "pictures and gridmaps"};
  job.print(options.json ? jsonSummary(head, map, inserter, job.seconds())
                         : textSummary(head, map, inserter, job.seconds()));
  return 0;
}

void addSlice(CLI::App& app, const std::string& name, std::vector<double>& ends,
              const std::string& help)
{
  app.add_option("--" + name, ends, help)
      ->type_size(2)
      ->expected(1)  // else a vector takes all that follows, and INPUT with it
      ->check(isFinite())
      ->type_name("MIN MAX");
}

void addMethodOptions(CLI::App& app, ScanFlags& flags)
{
  flags.grid.addTo(app, isNumber());
  flags.profile.addTo(app, isNumber());
  addSlice(app, "object", flags.object,
           "heights of what a robot can hit [m], default 0.05 1.5; the floor lies below");
  app.add_flag("--no-reflection-filter", flags.noReflectionFilter,
               "keep what is seen behind walls and in glass");
  addSlice(app, "structure", flags.structure,
           "heights just under the ceiling, where only walls are [m]; the reflection filter needs "
           "them");
  app.add_flag("--no-2d", flags.no2D, "leave out 2D scans of the log");
}

}  // namespace

std::pair<CLI::App*, Command> addInsert(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand(
      "insert", "Makes a 2D occupancy map of 3D scans: whole shapes, reflections cut");
  auto options = std::make_shared<InsertOptions>();
  sub->add_option("INPUT", options->file,
                  std::string("a .rawlog or .simplemap with 3D scans") + kOrStdin)
      ->required()
      ->type_name("");
  addOutputOptions(*sub, options->outputDir, options->json);
  sub->add_option("-c,--config", options->iniFile, "options: sections [scanInsertion], [map]")
      ->type_name("FILE.ini");
  addMethodOptions(*sub, options->flags);
  addPoseOptions(*sub, options->log);
  addGeoOptions(*sub, options->geo);
  sub->footer(
      "Example:\n"
      "  mapconv insert office.rawlog -o map --structure 2.2 2.6\n"
      "  mapconv insert office.simplemap -o map -c config/scanShapeGrid/insert.ini --model "
      "closestPoint\n"
      "Heights are those above the robot's base. DIR gets map.gridmap, .pgm, .yaml, .png and .tif\n"
      "(probability of occupancy). 2D scans of the log are inserted as well, unless --no-2d is\n"
      "given or the ini file says insert2D = false. A return at a 3D scan's maximum range is "
      "none,\n"
      "and frees nothing: a beam that meets nothing says nothing of what is above or below it.");
  return {sub, [options] { return insert(*options); }};
}

}  // namespace mapconv
