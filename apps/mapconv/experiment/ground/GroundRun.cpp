#include "experiment/ground/GroundRun.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
GroundResult resultOf(const std::string& name, const eval::LabelledCloud& labelled)
{
  const std::size_t points = labelled.cloud.size();
  return {
      name, points, static_cast<double>(labelled.groundPoints()) / static_cast<double>(points), {}};
}

/** \param world the map is compared with; null: there is none */
GroundRun runFilter(const NamedFilter& filter, const eval::LabelledCloud& labelled,
                    const sim::World* world, int threads)
{
  GroundRun run;
  run.filter = filter.name;
  Stopwatch watch;
  const aerial::Ground ground = aerial::findGround(labelled.cloud, filter.params, threads);
  run.seconds = watch.lap();
  run.points = eval::scoreGround(ground.classification, labelled.truth);
  if (!world) return run;
  const auto truth = eval::trueGround(*world, ground.layers.ground.frame());
  run.map = eval::scoreGroundMap(ground.layers, truth);
  run.errors = ground.layers.ground;
  for (std::size_t i = 0; i < truth.cells().size(); ++i) run.errors.cells()[i] -= truth.cells()[i];
  return run;
}
}  // namespace

GroundResult runForest(const GroundWorld& world, const GroundExperimentSettings& settings,
                       Progress& progress)
{
  progress.stage("flying over " + world.name);
  const sim::Scenario scenario = sim::Scenario::load(world.file);
  const auto labelled = eval::simulateCloud(scenario, settings.seed, settings.everyScan,
                                            [&](double share) { progress.done(share); });
  GroundResult result = resultOf(world.name, labelled);
  for (const NamedFilter& filter : settings.filters)
  {
    progress.stage("finding the ground of " + world.name + " by " + filter.name);
    result.runs.push_back(runFilter(filter, labelled, &scenario.world, settings.threads));
  }
  return result;
}

GroundResult runSample(const GroundSample& sample, const GroundExperimentSettings& settings)
{
  const auto labelled = eval::readLabelledCloud(sample.file, sample.groundFile);
  GroundResult result = resultOf(sample.name, labelled);
  for (const NamedFilter& filter : settings.filters)
    result.runs.push_back(runFilter(filter, labelled, nullptr, settings.threads));
  return result;
}

}  // namespace mapconv
