#include "experiment/freespace/Exploration.h"

#include <mrpt_mapconv/eval/LeafProjection.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/sim/SimulationFiles.h>
#include <mrpt_mapconv/sim/Simulator.h>
#include <mrpt_mapconv/sim/Truth.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>

#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
constexpr std::uint64_t kSeed = 1;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/** The 2D maps that follow the voxel map. */
class FollowingMaps
{
 public:
  FollowingMaps(const octomap::OcTree& tree, const freespace::ConversionParams& params,
                double sliceMin, double sliceMax)
      : m_tree(tree),
        m_source(tree),
        m_layers(params, 1),
        m_sliceMin(sliceMin),
        m_sliceMax(sliceMax)
  {
  }

  UpdateCost update(const voxel::ColumnSet& changed)
  {
    UpdateCost cost;
    cost.changedColumns = changed.size();
    for (std::size_t i = 0; i < kMethods; ++i)
    {
      const std::size_t method = (i + m_first) % kMethods;
      Stopwatch watch;
      update(static_cast<Method>(method), changed);
      cost.ms[method] = 1e3 * watch.lap();
    }
    ++m_first;
    return cost;
  }

 private:
  void update(Method method, const voxel::ColumnSet& changed)
  {
    switch (method)
    {
      case Method::FreeSpace:
        m_layers.update(m_source, changed);
        break;
      case Method::Slice:
        freespace::updateFixed(m_source, changed, m_sliceMin, m_sliceMax, m_slice, 1);
        break;
      case Method::WholeHeight:
        freespace::updateFixed(m_source, changed, -kInfinite, kInfinite, m_whole, 1);
        break;
      case Method::SliceByLeaves:
        updateByLeaves(changed, m_sliceMin, m_sliceMax, m_sliceByLeaves);
        break;
      case Method::WholeHeightByLeaves:
        updateByLeaves(changed, -kInfinite, kInfinite, m_wholeByLeaves);
        break;
    }
  }

  /** OctoMap's server updates the rectangle around what has changed. */
  void updateByLeaves(const voxel::ColumnSet& changed, double zMin, double zMax,
                      grid::Layer<float>& layer) const
  {
    const grid::GridFrame cells = changed.bounds(m_tree.getResolution());
    const grid::GridFrame frame = freespace::grownFrame(layer.frame(), cells);
    if (frame != layer.frame()) layer = layer.onFrame(frame, grid::kUnknown);
    eval::projectByLeaves(m_tree, zMin, zMax, cells, layer);
  }

  const octomap::OcTree& m_tree;
  voxel::OctreeSource<octomap::OcTree> m_source;
  freespace::IncrementalLayers m_layers;
  grid::Layer<float> m_slice, m_whole, m_sliceByLeaves, m_wholeByLeaves;
  double m_sliceMin, m_sliceMax;
  std::size_t m_first = 0;
};

/** Inserts a moment's 3D scans. \return the columns that have changed */
voxel::ColumnSet insertScans(const sim::Moment& moment, Exploration& run)
{
  std::vector<observation::PosedObservation> scans;
  for (const sim::Scan& scan : moment.scans)
    scans.push_back({scan.observation, moment.estimatedPose});
  voxel::TVoxelInsertionOptions only3D;
  only3D.insert2D = false;
  auto inserted = voxel::insertScans(*run.tree, scans, only3D);
  run.scans += inserted.scans;
  run.points += inserted.points;
  return std::move(inserted.changed);
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
  std::optional<FollowingMaps> maps;
  if (world.paper)
    maps.emplace(*run.tree, settings.conversion, run.startHeight - world.sliceBelow,
                 run.startHeight + world.sliceAbove);
  sim::Simulator simulator(scenario, kSeed);
  while (const auto moment = simulator.next())
  {
    progress.done(moment->seconds / scenario.trajectory.duration());
    sim::countReturns(*moment, run.inView);
    const auto changed = insertScans(*moment, run);
    if (maps && !changed.empty()) run.updates.push_back(maps->update(changed));
    if (settings.maxScans > 0 && run.scans >= static_cast<std::size_t>(settings.maxScans)) break;
  }
  return run;
}

}  // namespace mapconv
