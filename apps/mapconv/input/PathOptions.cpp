#include "input/PathOptions.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "input/InputOptions.h"
#include "input/UsageError.h"
#include "output/Console.h"
#include "output/Json.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using freespace::Robot;

namespace
{
void checkSafetyRadius(double radius, const PathOptions& options, double minClearance)
{
  if (radius > 0 && radius <= minClearance / 2) return;
  throw UsageError(std::string(options.safetyRadius ? "--safety-radius " : "--robot-radius ") +
                   jsonNumber(radius) + " is not valid for an aerial robot: " +
                   "it must be > 0 and at most half of the map's minClearance = " +
                   jsonNumber(minClearance) + " m");
}

void warnOfSphereOptions(const PathOptions& options)
{
  if (options.safetyRadius) printWarning("--safety-radius has no effect: a ground robot has none");
  if (options.unknownIsPassable)
    printWarning("--unknown-is-passable has no effect: a ground robot has no sphere");
}
}  // namespace

void addPathOptions(CLI::App& app, PathOptions& options, const std::string& safetyDefault)
{
  app.add_option("DIR", options.dir, "output folder of mapconv convert")->required()->type_name("");
  app.add_option("--robot", options.robot, "ground or aerial")
      ->required()
      ->check(CLI::IsMember({"ground", "aerial"}))
      ->type_name("");
  app.add_option("-o,--output", options.outputFile, "the file to write: columns x,y,z [m]")
      ->required()
      ->type_name("FILE.csv");
  app.add_option("--height-offset", options.heightOffset,
                 "height above the highest floor around [m], default 0 for a ground robot, half "
                 "the map's minClearance for an aerial one")
      ->check(isNotNegative())
      ->type_name("M");
  app.add_option("--lookahead", options.lookahead,
                 "how far ahead and behind the floor is looked at, along the path [m], default 0.5")
      ->check(isNotNegative())
      ->type_name("M");
  app.add_option("--safety-radius", options.safetyRadius,
                 "of an aerial robot's sphere [m], at most half the map's minClearance, default " +
                     safetyDefault)
      ->check(isNotNegative())
      ->type_name("M");
  app.add_flag("--unknown-is-passable", options.unknownIsPassable,
               "an aerial robot's sphere may reach into cells of which nothing is known");
  app.add_flag("--json", options.json, "print the summary as one JSON object");
}

path::LiftParams liftParamsOf(const PathOptions& options, const MapFolder& map, double safetyRadius)
{
  path::LiftParams params;
  params.shownOrigin = map.reference().origin;
  params.robot = options.robot == "ground" ? Robot::Ground : Robot::Aerial;
  params.safetyRadius = options.safetyRadius.value_or(safetyRadius);
  params.heightOffset = options.heightOffset.value_or(
      params.robot == Robot::Ground ? 0.0 : map.params().minClearance / 2);
  params.unknownIsPassable = options.unknownIsPassable;
  if (options.lookahead) params.lookahead = *options.lookahead;
  if (params.robot == Robot::Aerial)
    checkSafetyRadius(params.safetyRadius, options, map.params().minClearance);
  else
    warnOfSphereOptions(options);
  return params;
}

void checkCsvName(const std::string& file)
{
  const std::filesystem::path path = file;
  if (path.extension() != ".csv" || path.stem().empty())
    throw UsageError("-o " + file + ": it must be a name that ends in .csv");
}

}  // namespace mapconv
