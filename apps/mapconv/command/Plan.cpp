#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/freespace/DropEdges.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/planning/Remedies.h>
#include <mrpt_mapconv/planning/RobotPath.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "command/Command.h"
#include "input/InputOptions.h"
#include "input/PathOptions.h"
#include "output/Job.h"
#include "output/PathScene.h"
#include "output/PathSummary.h"
#include "output/Summary.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using freespace::Robot;

namespace
{
struct PlanOptions : PathOptions
{
  std::vector<double> from, to;
  double robotRadius = 0;
};

std::vector<mrpt::math::TPoint2D> flat(const path::LiftedPath& path)
{
  std::vector<mrpt::math::TPoint2D> points;
  for (const auto& point : path.points) points.emplace_back(point.position.x, point.position.y);
  return points;
}

/** The path's files lie beside each other and differ in their extension. */
void writeOutputs(const PlanOptions& options, const MapFolder& map, const planning::RobotPath& way,
                  files::OutputDir& out)
{
  const std::filesystem::path file = options.outputFile;
  const std::string stem = file.stem().string();
  const auto edges = freespace::dropEdges(map.layers(), map.params());
  auto picture = grid::findLayer(map.layers().styled(edges), options.robot);
  picture.title = "Path of the " + options.robot + " robot";
  const grid::PicturePath path{flat(way.path),
                               "path, " + pathLengths(way.path) + ", from the ring to the disc"};
  files::writeFile(out.path(file.filename().string()), pathCsv(way.path));
  grid::writeLayerPng(out.path(stem + ".png"), picture, path);
  writePathScene(out.path(stem + ".3Dscene"), map.layers(), picture, map.octree(), way.path);
}

/** What would have to change so that there is a path; empty if nothing does. */
std::string remediesText(const planning::Remedies& remedies)
{
  using params::roundedText;
  std::string text;
  const auto add = [&](const char* flag, const std::optional<double>& value)
  {
    if (value)
      text += (text.empty() ? "; there is one with " : ", or with ") + (flag + roundedText(*value));
  };
  add("--robot-radius ", remedies.robotRadius);
  add("--height-offset ", remedies.heightOffset);
  if (remedies.maxStep)
    text += "; for a robot that climbs " + roundedText(*remedies.maxStep) +
            " m: a map converted with --max-step " + roundedText(*remedies.maxStep);
  if (remedies.maxStepUnknown)
    text += std::string(
                "; whether a map converted with a higher --max-step would help cannot be "
                "told without ") +
            MapFolder::kVoxels;
  return text;
}

int plan(const PlanOptions& options)
{
  checkCsvName(options.outputFile);
  Job job;
  const MapFolder map =
      job.stage("load", "reading " + options.dir, [&] { return MapFolder(options.dir); });
  planning::RobotPathQuery query;
  const auto& origin = map.reference().origin;
  query.start = {options.from[0] - origin.x, options.from[1] - origin.y};
  query.goal = {options.to[0] - origin.x, options.to[1] - origin.y};
  query.robotRadius = options.robotRadius;
  query.lift = liftParamsOf(options, map, options.robotRadius);
  const auto way = job.stage(
      "plan", "planning",
      [&] { return planning::planRobotPath(map.layers(), map.params(), query, map.voxels()); });
  if (!way.found())
  {
    job.progress().stage("trying what would help");
    throw std::runtime_error(
        options.dir + ": no path: " + way.problem +
        remediesText(planning::findRemedies(map.layers(), map.params(), query, map.voxels())));
  }
  const std::string folder = std::filesystem::path(options.outputFile).parent_path().string();
  job.write(folder.empty() ? "." : folder,
            [&](files::OutputDir& out) { writeOutputs(options, map, way, out); });
  JsonObject json = pathJson(way.path);
  job.print(options.json ? json.add("output", options.outputFile).text() + "\n"
                         : fromTo(options.dir, options.outputFile) + pathText(way.path));
  return 0;
}

CLI::Option* addPlace(CLI::App& app, const std::string& flag, std::vector<double>& place,
                      const std::string& what)
{
  return app.add_option(flag, place, what)
      ->required()
      ->expected(2)
      ->delimiter(',')
      ->check(isNumber())
      ->type_name("X,Y");
}
}  // namespace

std::pair<CLI::App*, Command> addPlan(CLI::App& app)
{
  CLI::App* sub =
      app.add_subcommand("plan", "Plans a path on a converted map and gives it heights");
  auto options = std::make_shared<PlanOptions>();
  addPathOptions(*sub, *options, "--robot-radius");
  addPlace(*sub, "--from", options->from, "where the robot is [m]");
  addPlace(*sub, "--to", options->to, "where it is to go [m]");
  sub->add_option("--robot-radius", options->robotRadius, "of the robot's outline [m]")
      ->required()
      ->check(isNotNegative())
      ->type_name("R");
  sub->footer(
      "Example:\n"
      "  mapconv plan maps --robot ground --from -3,1.5 --to 7,4 --robot-radius 0.25 -o path.csv\n"
      "Beside path.csv appear path.png (over the map) and path.3Dscene (in the voxel map).\n"
      "The path keeps to free cells whose square is at least the robot's radius away from the\n"
      "square of every cell that is not free; a corridor of n cells is wide enough from\n"
      "n = 2 radius/resolution + 1 on, rounded up to an odd number. A ground robot climbs no\n"
      "change of height above max(maxStep, one voxel, maxSlope x distance) from point to point\n"
      "(a distance of less than a cell counts as one), and no straight piece of a path crosses\n"
      "an occupied voxel.\n"
      "Without a path the exit status is 1; the message says why, and which flag would help.");
  return {sub, [options] { return plan(*options); }};
}

}  // namespace mapconv
