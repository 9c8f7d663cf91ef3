#include "FreespaceMaps.h"

#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>

#include <limits>

namespace mapconv
{
using namespace mrpt_mapconv;

FreespaceMaps makeMaps(const Exploration& run, const sim::Scenario& scenario,
                       const FreespaceWorld& world, const FreespaceSettings& settings,
                       Progress& progress)
{
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const voxel::OctreeSource<octomap::OcTree> source(*run.tree);
  FreespaceMaps maps;
  for (int i = 0; i < settings.repetitions; ++i)
  {
    progress.done(static_cast<double>(i) / settings.repetitions);
    Stopwatch watch;
    maps.layers = freespace::convert(source, settings.conversion, 1);
    maps.costs.full.push_back(1e3 * watch.lap());
    maps.slice = freespace::projectFixed(source, run.startHeight - world.sliceBelow,
                                         run.startHeight + world.sliceAbove, 1);
    maps.costs.slice.push_back(1e3 * watch.lap());
    maps.wholeHeight = freespace::projectFixed(source, -kInfinite, kInfinite, 1);
    maps.costs.wholeHeight.push_back(1e3 * watch.lap());
  }
  maps.strict = freespace::convert(source, settings.strictConversion);
  maps.truth = sim::truthLayers(scenario.world, run.inView.frame(), scenario.truth);
  maps.seen = sim::cellsFrom(run.inView, 1);
  return maps;
}

}  // namespace mapconv
