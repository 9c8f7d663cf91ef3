#include <mrpt/core/format.h>

#include <filesystem>

#include "experiment/Experiments.h"
#include "experiment/terrain/TerrainReport.h"

namespace mapconv
{
namespace
{
TerrainWorldResult runWorld(const TerrainWorld& world, const TerrainExperimentSettings& settings,
                            Progress& progress)
{
  progress.stage("walking through " + world.name);
  const TerrainWalk walk(world.file, settings.poseNoise, settings.seed, settings.maxScans,
                         progress);
  TerrainWorldResult result{world, walk.scans(0).size(), walk.points(), {}};
  for (const double resolution : settings.resolutions)
  {
    progress.stage("mapping " + world.name + " at " + metres(resolution) + " m");
    result.runs.push_back(runTerrain(walk, world, resolution, settings, progress));
  }
  return result;
}

/** Real scans, or a line that they are not there. */
void addReal(const TerrainExperimentSettings& settings, Progress& progress, Report& report)
{
  if (!settings.real) return;
  if (!std::filesystem::exists(settings.real->file))
  {
    report.addHeading("Real scans");
    report.addText("Left out: there is no " + settings.real->file + ".");
    return;
  }
  progress.stage("mapping real scans");
  addRealScans(mapRealScans(*settings.real, settings), report);
}
}  // namespace

const PerTerrainHeights<std::string>& heightsNames()
{
  static const PerTerrainHeights<std::string> names = {
      "ours (fused)", "ours (maximum)", "elevation map (fused)", "elevation map (not fused)"};
  return names;
}

const PerTerrainMethod<std::string>& methodNames()
{
  static const PerTerrainMethod<std::string> names = {"ours (fused)",
                                                      "ours (maximum)",
                                                      "ours (fused) on 2 threads",
                                                      "ours (maximum) on 2 threads",
                                                      "elevation map (fused)",
                                                      "elevation map (not fused)",
                                                      "CHeightGridMap2D",
                                                      "octomap"};
  return names;
}

std::string metres(double value) { return mrpt::format("%g", value); }
std::string millimetres(double value) { return fixed(1e3 * value, 2); }

void runTerrainExperiment(const ExperimentJob& job, Report& report)
{
  const TerrainExperimentSettings settings = readTerrainExperimentSettings(job);
  TerrainResults results;
  for (const TerrainWorld& world : settings.worlds)
    results.push_back(runWorld(world, settings, job.progress));
  job.progress.stage("writing tables");
  for (const TerrainWorldResult& result : results)
    report.addText(mrpt::format("**%s**: %zu scans with %.1f million points.",
                                result.world.name.c_str(), result.scans,
                                1e-6 * static_cast<double>(result.points)));
  addTimes(results, settings, report);
  addHeightErrors(results, settings, report);
  addSizes(results, report);
  addPlanes(results, settings, report);
  addSteps(results, settings, report);
  addReal(settings, job.progress, report);
  job.progress.stage("drawing maps");
  addPictures(results, report);
}

}  // namespace mapconv
