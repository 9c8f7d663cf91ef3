#include <mrpt/core/format.h>
#include <mrpt_mapconv/freespace/DropEdges.h>
#include <mrpt_mapconv/grid/LayerPicture.h>

#include <stdexcept>

#include "experiment/Experiments.h"
#include "experiment/freespace/FreespaceResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** \exception std::runtime_error for a name with which no body of the world begins */
void checkNames(const std::vector<std::string>& names, const sim::World& bodies,
                const FreespaceWorld& world, const std::string& key)
{
  for (const std::string& start : names)
  {
    bool any = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) any |= bodies.nameBegins(i, start);
    if (!any)
      throw std::runtime_error("section '" + world.name + "': " + key + ": no body of " +
                               world.file + " has a name that begins with '" + start + "'");
  }
}

FreespaceResult resultOf(const FreespaceWorld& world, const FreespaceSettings& settings,
                         Progress& progress)
{
  FreespaceResult result;
  result.world = world;
  progress.stage("reading " + world.file);
  result.scenario =
      std::make_shared<const sim::Scenario>(sim::Scenario::load(world.file, world.sensors));
  checkNames(world.lowWalls, result.scenario->world, world, "lowWalls");
  checkNames(world.objects, result.scenario->world, world, "objects");
  if (world.drops) checkNames({world.drops->ramp}, result.scenario->world, world, "ramp");
  progress.stage("exploring " + world.name);
  result.run = explore(*result.scenario, world, settings, progress);
  progress.stage("converting " + world.name);
  result.maps = makeMaps(result.run, *result.scenario, world, settings, progress);
  progress.stage("paths of the ground robot in " + world.name);
  result.groundRuns = planGroundPairs(world, result.scenario->world, *result.run.tree, result.maps,
                                      settings.pairs, progress);
  return result;
}

void addGroundPicture(const std::string& world, const GroundMap& map, Report& report)
{
  const auto edges = freespace::dropEdges(map.layers, map.params);
  const auto styled = map.layers.styled(edges);
  grid::writeLayerPng(
      report.addPicture(world + "_ground_" + map.name, world + ": ground robot, " + map.name),
      grid::findLayer(styled, "ground"));
}

void addWorld(const FreespaceResult& result, Report& report)
{
  const auto& frame = result.maps.ground.front().layers.frame();
  const std::string& name = result.world.name;
  report.addText(
      mrpt::format("**%s**: %zu scans, %.1f million points, %zu leaves of %.2f m, %zu x %zu m.",
                   name.c_str(), result.run.scans, static_cast<double>(result.run.points) / 1e6,
                   result.run.tree->getNumLeafNodes(), frame.resolution,
                   static_cast<std::size_t>(frame.width * frame.resolution),
                   static_cast<std::size_t>(frame.height * frame.resolution)));
  constexpr auto kOccupancy = grid::LayerKind::Occupancy;
  const auto& maps = result.maps;
  for (const GroundMap& map : maps.ground) addGroundPicture(name, map, report);
  if (result.world.paper)
  {
    grid::writeLayerPng(report.addPicture(name + "_floor", name + ": floor"),
                        maps.layers.styled("floor"));
    grid::writeLayerPng(
        report.addPicture(name + "_slice", name + ": fixed projection of the slice"),
        {"slice", &maps.slice, "Fixed projection of the slice", "", kOccupancy});
  }
  grid::writeLayerPng(
      report.addPicture(name + "_truth", name + ": the truth, ground robot"),
      {"truth", &maps.truth.ground, "Truth: where a ground robot can be", "", kOccupancy});
}
}  // namespace

void runFreespaceExperiment(const ExperimentJob& job, Report& report)
{
  const FreespaceSettings settings = readFreespaceSettings(job);
  std::vector<FreespaceResult> results;
  for (const FreespaceWorld& world : settings.worlds)
    results.push_back(resultOf(world, settings, job.progress));
  const Results all(results.begin(), results.end());
  Results ofPaper, withDrops;
  for (const FreespaceResult& result : all)
  {
    if (result.world.paper) ofPaper.emplace_back(result);
    if (result.world.drops) withDrops.emplace_back(result);
  }
  job.progress.stage("writing tables and plots");
  if (!ofPaper.empty())
  {
    addSpeed(ofPaper, report);
    addSizes(ofPaper, report);
    addQuality(ofPaper, report);
    addPaths(ofPaper, settings, job.progress, report);
  }
  job.progress.stage("judging ground maps");
  addGround(all, report);
  if (!withDrops.empty()) addDrops(withDrops, report);
  job.progress.stage("drawing maps");
  report.addHeading("Maps");
  for (const FreespaceResult& result : all) addWorld(result, report);
}

}  // namespace mapconv
