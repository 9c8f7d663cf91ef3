#include "experiment/freespace/FreespaceMaps.h"

#include <mrpt_mapconv/eval/LeafProjection.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>

#include <functional>
#include <limits>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
grid::Layer<float> projectAllByLeaves(const octomap::OcTree& tree, const voxel::VoxelSource& source,
                                      double zMin, double zMax)
{
  const grid::GridFrame frame = freespace::frameOf(source);
  grid::Layer<float> layer(frame, grid::kUnknown);
  eval::projectByLeaves(tree, zMin, zMax, frame, layer);
  return layer;
}

void makePaperMaps(const Exploration& run, const FreespaceWorld& world,
                   const FreespaceSettings& settings, Progress& progress, FreespaceMaps& maps)
{
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const double sliceMin = run.startHeight - world.sliceBelow;
  const double sliceMax = run.startHeight + world.sliceAbove;
  const voxel::OctreeSource<octomap::OcTree> source(*run.tree);
  grid::Layer<float> byLeaves;
  const PerMethod<std::function<void()>> methods = {
      [&] { maps.layers = freespace::convert(source, settings.conversion, 1); },
      [&] { maps.slice = freespace::projectFixed(source, sliceMin, sliceMax, 1); },
      [&] { maps.wholeHeight = freespace::projectFixed(source, -kInfinite, kInfinite, 1); },
      [&] { byLeaves = projectAllByLeaves(*run.tree, source, sliceMin, sliceMax); },
      [&] { byLeaves = projectAllByLeaves(*run.tree, source, -kInfinite, kInfinite); }};
  for (int i = 0; i < settings.repetitions; ++i)
  {
    progress.done(static_cast<double>(i) / settings.repetitions);
    for (std::size_t method = 0; method < kMethods; ++method)
    {
      Stopwatch watch;
      methods[method]();
      maps.costs[method].push_back(1e3 * watch.lap());
    }
  }
}

GroundMap groundMap(const std::string& name, const voxel::VoxelSource& source,
                    freespace::ConversionParams params, freespace::FloorFrom floorFrom)
{
  params.floorFrom = floorFrom;
  return {name, params, freespace::convert(source, params)};
}
}  // namespace

FreespaceMaps makeMaps(const Exploration& run, const sim::Scenario& scenario,
                       const FreespaceWorld& world, const FreespaceSettings& settings,
                       Progress& progress)
{
  const voxel::OctreeSource<octomap::OcTree> source(*run.tree);
  FreespaceMaps maps;
  if (world.paper) makePaperMaps(run, world, settings, progress, maps);
  maps.ground = {groundMap("strict", source, world.strict, freespace::FloorFrom::LowestFree),
                 groundMap("seen", source, world.strict, freespace::FloorFrom::Seen)};
  maps.truth = sim::truthLayers(scenario.world, run.inView.frame(), scenario.truth);
  maps.inView = eval::cellsFrom(run.inView, 1);
  return maps;
}

}  // namespace mapconv
