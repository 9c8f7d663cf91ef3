#include <filesystem>

#include "experiment/Experiments.h"
#include "experiment/ground/GroundTables.h"

namespace mapconv
{
namespace
{
bool isThere(const GroundSample& sample)
{
  return std::filesystem::exists(sample.file) && std::filesystem::exists(sample.groundFile);
}

/** Real clouds; a line for those that are not there. */
void runSamples(const GroundExperimentSettings& settings, Progress& progress, Report& report)
{
  std::vector<GroundResult> results;
  std::vector<std::string> missing;
  for (const GroundSample& sample : settings.samples)
  {
    progress.stage("finding the ground of sample " + sample.name);
    if (isThere(sample))
      results.push_back(runSample(sample, settings));
    else
      missing.push_back(sample.file);
  }
  if (!results.empty()) addSamples(results, report);
  for (const std::string& file : missing)
    report.addText("Left out: there is no " + file + ", or not its ground.");
}
}  // namespace

void runGroundExperiment(const ExperimentJob& job, Report& report)
{
  const GroundExperimentSettings settings = readGroundExperimentSettings(job);
  std::vector<GroundResult> forests;
  for (const GroundWorld& world : settings.worlds)
    forests.push_back(runForest(world, settings, job.progress));
  addForests(forests, settings, report);
  runSamples(settings, job.progress, report);
}

}  // namespace mapconv
