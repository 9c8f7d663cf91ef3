#include "Exploration.h"

#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/maps/ObservationPoints.h>
#include <mrpt_mapconv/maps/VoxelInsertion.h>
#include <mrpt_mapconv/sim/SimulationFiles.h>
#include <mrpt_mapconv/sim/Simulator.h>
#include <mrpt_mapconv/sim/Truth.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>

#include <array>
#include <functional>
#include <limits>
#include <stdexcept>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
constexpr std::uint64_t kSeed = 1;

/** The 2D maps that follow the voxel map. */
class FollowingMaps
{
 public:
  FollowingMaps(const freespace::ConversionParams& params, double sliceMin, double sliceMax)
      : m_layers(params, 1), m_sliceMin(sliceMin), m_sliceMax(sliceMax)
  {
  }

  UpdateCost update(const voxel::VoxelSource& source, const voxel::ColumnSet& changed)
  {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    UpdateCost cost;
    cost.changedColumns = changed.size();
    const std::array<std::function<void()>, 3> methods = {
        [&] { cost.full = timed([&] { m_layers.update(source, changed); }); },
        [&]
        {
          cost.slice = timed(
              [&] { freespace::updateFixed(source, changed, m_sliceMin, m_sliceMax, m_slice, 1); });
        },
        [&]
        {
          cost.wholeHeight = timed(
              [&] { freespace::updateFixed(source, changed, -kInfinite, kInfinite, m_whole, 1); });
        }};
    for (std::size_t i = 0; i < methods.size(); ++i) methods[(i + m_first) % methods.size()]();
    ++m_first;
    return cost;
  }

 private:
  static double timed(const std::function<void()>& work)
  {
    Stopwatch watch;
    work();
    return 1e3 * watch.lap();
  }

  freespace::IncrementalLayers m_layers;
  grid::Layer<float> m_slice, m_whole;
  double m_sliceMin, m_sliceMax;
  std::size_t m_first = 0;
};

/** Inserts a moment's 3D scans. \return the columns that have changed */
voxel::ColumnSet insertScans(const sim::Moment& moment, Exploration& run)
{
  voxel::ColumnSet changed;
  for (const sim::Scan& scan : moment.scans)
  {
    if (!scan.is3D) continue;
    const auto points = maps::sensorPoints(*scan.observation, moment.estimatedPose);
    if (!points || points->points.empty()) continue;
    changed.insert(maps::insertScan(*run.tree, *points, {}));
    ++run.scans;
    run.points += points->points.size();
  }
  return changed;
}

double sensorHeight(const sim::Scenario& scenario)
{
  for (const auto& sensor : scenario.sensors)
    if (sensor->is3D()) return (scenario.trajectory.poseAt(0) + sensor->params().pose).z();
  throw std::runtime_error("the world has no 3D sensor");
}
}  // namespace

Exploration explore(const sim::Scenario& scenario, const FreespaceWorld& world,
                    const FreespaceSettings& settings, Progress& progress)
{
  Exploration run;
  run.tree = std::make_unique<octomap::OcTree>(world.resolution);
  run.inView = grid::Layer<float>(sim::frameOf(scenario.world, world.resolution), 0);
  run.startHeight = sensorHeight(scenario);
  FollowingMaps maps(settings.conversion, run.startHeight - world.sliceBelow,
                     run.startHeight + world.sliceAbove);
  const voxel::OctreeSource<octomap::OcTree> source(*run.tree);
  sim::Simulator simulator(scenario, kSeed);
  while (const auto moment = simulator.next())
  {
    progress.done(moment->seconds / scenario.trajectory.duration());
    sim::countReturns(*moment, run.inView);
    const auto changed = insertScans(*moment, run);
    if (!changed.empty()) run.updates.push_back(maps.update(source, changed));
    if (settings.maxScans > 0 && run.scans >= static_cast<std::size_t>(settings.maxScans)) break;
  }
  return run;
}

}  // namespace mapconv
