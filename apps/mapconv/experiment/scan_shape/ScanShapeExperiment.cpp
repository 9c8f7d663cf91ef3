#include <mrpt/core/format.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <cmath>
#include <stdexcept>

#include "experiment/Experiments.h"
#include "experiment/scan_shape/ScanShapeResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** \exception std::runtime_error unless there are scans for all methods */
void checkSensors(const sim::Scenario& scenario, const std::string& file)
{
  bool any2D = false, any3D = false;
  for (const auto& sensor : scenario.sensors) (sensor->is3D() ? any3D : any2D) = true;
  if (!any2D || !any3D)
    throw std::runtime_error(file + ": this experiment needs a 3D sensor and a 2D scanner");
}

/** What is true around the world's bounds, so that all pictures show the same. */
grid::GridFrame pictureFrame(const eval::ScanShapeTruth& truth)
{
  constexpr double kMargin = 2;  // [m], where ghosts beyond the outer walls are seen
  grid::GridFrame frame = truth.obstacles.frame();
  const auto margin = static_cast<std::int32_t>(std::lround(kMargin / frame.resolution));
  frame.x0 -= margin;
  frame.y0 -= margin;
  frame.width += 2 * margin;
  frame.height += 2 * margin;
  return frame;
}

void addPictures(const ScanShapeResult& result, Report& report)
{
  const ScanShapeRun& run = result.runs.front();
  const grid::GridFrame frame = pictureFrame(result.truth);
  const auto add =
      [&](const std::string& name, const std::string& title, const grid::Layer<float>& map)
  {
    const auto shown = map.onFrame(frame, grid::kUnknown);
    grid::writeLayerPng(report.addPicture(name, title),
                        {name, &shown, title, "", grid::LayerKind::Occupancy});
  };
  report.addHeading("Maps of seed " + std::to_string(run.seed));
  add("truth", "The truth: what the robot can hit", result.truth.obstacles);
  const PerScanMethod<std::string> names = {"scanner_2d", "closest_point", "counts",
                                            "whole_shape_uncut", "whole_shape_cut"};
  for (std::size_t i = 0; i < kScanMethods; ++i)
    add(names[i], "Map: " + methodName(static_cast<ScanMethod>(i)), run.maps[i]);
}

std::string runText(const ScanShapeRun& run)
{
  return mrpt::format(
      "Seed %u: %zu 3D scans with %.1f million points, %zu 2D scans of which MRPT refused %zu. "
      "%.1f %% of the azimuths had a wall.",
      run.seed, run.scans3D, static_cast<double>(run.points) / 1e6, run.scans2D, run.refused2D,
      100 * run.shareWithWall);
}

/** \exception std::runtime_error naming section and key of a rectangle that holds no place to
 * be */
void checkRegions(const ExperimentJob& job, const sim::World& world, const ScanShapeResult& result)
{
  const auto check =
      [&](const eval::MapRegion& region, const std::string& key, const auto& rectangle)
  {
    if (!eval::isPlaceIn(rectangle, world, result.truth))
      failRegion(job, region, key, "a rectangle within the world's bounds with a truly free cell");
  };
  for (const eval::MapRegion& region : result.settings.regions)
  {
    check(region, "area", region.area);
    check(region, "room", region.room);
  }
}

/** One run for each seed. \param name of these drives, for who waits for them */
std::vector<ScanShapeRun> drives(const ExperimentJob& job, const sim::Scenario& scenario,
                                 const ScanShapeResult& result, const std::string& name,
                                 const std::vector<std::uint32_t>& seeds, bool withSweep)
{
  std::vector<ScanShapeRun> runs;
  for (const std::uint32_t seed : seeds)
  {
    job.progress.stage(name + ", " + std::to_string(runs.size() + 1) + " of " +
                       std::to_string(seeds.size()));
    runs.push_back(
        driveThrough(scenario, result.truth, result.settings, seed, withSweep, job.progress));
    if (withSweep || runs.size() > 1) runs.back().maps = {};
  }
  return runs;
}

ScanShapeResult computed(const ExperimentJob& job)
{
  ScanShapeResult result;
  result.settings = readScanShapeSettings(job);
  job.progress.stage("reading " + result.settings.world);
  const auto scenario = sim::Scenario::load(result.settings.world);
  checkSensors(scenario, result.settings.world);
  job.progress.stage("computing the truth");
  result.truth = eval::truthOf(scenario, result.settings.resolution, result.settings.profile,
                               result.settings.regions);
  checkRegions(job, scenario.world, result);
  const ScanShapeSettings& settings = result.settings;
  result.runs = drives(job, scenario, result, "driving", settings.seeds, false);
  result.sweepRuns =
      drives(job, scenario, result, "driving for the sweep", settings.sweep.seeds, true);
  return result;
}
}  // namespace

void runScanShapeExperiment(const ExperimentJob& job, Report& report)
{
  const ScanShapeResult result = computed(job);
  job.progress.stage("writing tables");
  for (const ScanShapeRun& run : result.runs) report.addText(runText(run));
  addScores(result, report);
  addCut(result, report);
  addPeople(result, report);
  addSweep(result, report);
  job.progress.stage("drawing maps");
  addPictures(result, report);
}

}  // namespace mapconv
