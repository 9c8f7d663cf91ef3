#include <mrpt_mapconv/aerial/Ground.h>
#include <mrpt_mapconv/aerial/GroundFiles.h>
#include <mrpt_mapconv/files/OutputDir.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "command/Command.h"
#include "input/CloudInput.h"
#include "input/GroundSettings.h"
#include "input/InputFile.h"
#include "input/InputOptions.h"
#include "input/PointInput.h"
#include "output/ClassifiedPoints.h"
#include "output/GroundReport.h"
#include "output/Job.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct GroundOptions
{
  PointRequest input;
  std::string iniFile, outputDir;
  std::string pointsFile;  // empty: none
  FieldFlags<aerial::GroundParams> flags;
  int threads = 0;
  bool json = false;
};

aerial::Ground groundBelow(const cloud::PointCloud& cloud, const std::string& name,
                           const aerial::GroundParams& params, int threads)
{
  try
  {
    return aerial::findGround(cloud, params, threads);
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(name + ": " + error.what());
  }
}

void writeMap(const GroundResult& result, const grid::GeoReference& reference,
              files::OutputDir& out, Progress& progress)
{
  grid::ExportFormats formats{"ground.tif"};
  formats.pictures = true;
  formats.reference = reference;
  aerial::exportGround(out, result.ground.layers, result.params, formats,
                       [&](double share) { progress.done(share); });
}

int mapGround(const GroundOptions& options)
{
  Job job;
  const aerial::GroundParams params = readGroundParams(options.iniFile, options.flags);
  job.checkOutput(options.outputDir);
  if (!options.pointsFile.empty())  // complains now, not after minutes of work
    static_cast<void>(ClassifiedPoints(options.pointsFile, options.input.file));

  NoEffect noEffect;
  PointInput input =
      job.stage("load", [&] { return readPoints(options.input, noEffect, job.progress()); });
  noEffect.warn();
  const std::string name = shownName(options.input.file);
  GroundResult result{
      params,
      job.stage("ground", "finding the ground of " + name,
                [&] { return groundBelow(input.cloud, name, params, options.threads); }),
      options.pointsFile};
  warnAboutGround(result);
  std::optional<ClassifiedPoints> points;
  if (!options.pointsFile.empty()) points.emplace(options.pointsFile, options.input.file);
  job.write(
      options.outputDir,
      [&](files::OutputDir& out)
      {
        writeMap(result, input.reference, out, job.progress());
        if (points) points->write(std::move(input.cloud), result.ground.classification);
      },
      points ? &points->file() : nullptr);

  const SummaryHead head{name,
                         input.description,
                         options.outputDir,
                         result.ground.layers.ground.frame(),
                         input.reference,
                         "pictures"};
  job.print(options.json ? groundJson(head, result, job.seconds())
                         : groundText(head, result, job.seconds()));
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addGround(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand(
      "ground", "Finds the ground below a cloud of points: its height, and heights above it");
  auto options = std::make_shared<GroundOptions>();
  sub->add_option("INPUT", options->input.file,
                  std::string("a .las, .ply, .pcd, text or KITTI cloud, scans (.rawlog, "
                              ".simplemap), or a voxel map") +
                      kOrStdin)
      ->required()
      ->type_name("");
  addOutputOptions(*sub, options->outputDir, options->json);
  sub->add_option("-c,--config", options->iniFile, "options: section [ground]")
      ->type_name("FILE.ini");
  options->flags.addTo(*sub, isNumber());
  sub->add_option("--points", options->pointsFile,
                  "writes the points with their class, 2 ground or 1 other, in their order: .las, "
                  ".ply, .pcd, .xyz, .txt or .csv")
      ->type_name("FILE");
  addColumnsOption(*sub, options->input.columns);
  addPoseOptions(*sub, options->input.log);
  addGeoOptions(*sub, options->input.geo);
  addUnitOption(*sub, options->input.geo);
  addThreadsOption(*sub, options->threads);
  sub->footer(
      "Example:\n"
      "  mapconv ground survey.las -o map --points classified.las\n"
      "DIR gets ground.tif with the bands ground (height), evidence (1 measured, 2 inferred),\n"
      "surface, aboveGround (canopy height), groundPoints and allPoints, and a picture of each.");
  return {sub, [options] { return mapGround(*options); }};
}

}  // namespace mapconv
