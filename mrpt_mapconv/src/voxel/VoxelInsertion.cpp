#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelGridSource.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/OcTree.h>

#include <stdexcept>

#include "BeamInsertion.h"
#include "BeamMask.h"
#include "BeamVoxels.h"
#include "MemoryLimit.h"

namespace mrpt_mapconv::voxel
{
namespace
{
ColumnSet changedColumns(octomap::OcTree& tree)
{
  ColumnSet columns;
  for (auto it = tree.changedKeysBegin(); it != tree.changedKeysEnd(); ++it)
    columns.insert(it->first[0] - kOctomapKeyOffset, it->first[1] - kOctomapKeyOffset);
  tree.resetChangeDetection();
  return columns;
}

ColumnSet allColumns(const VoxelSource& source)
{
  const auto box = source.bounds();
  return box ? ColumnSet::of(frameOf(*box, source.resolution())) : ColumnSet{};
}
}  // namespace

ScanBeams beamsOf(double resolution, const observation::SensorPoints& scan,
                  const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings)
{
  ScanBeams beams(OctomapKeys(resolution), scan, options.maxrange);
  if (beams.outside > 0 && warnings)
    warnings->warn(std::to_string(beams.outside) +
                   " points left out: farther from the map's origin than " +
                   std::to_string(kOctomapKeyOffset * resolution) +
                   " m, the reach of a tree of this resolution");
  return beams;
}

ColumnSet insertBeams(octomap::OcTree& tree, const ScanBeams& beams,
                      const TVoxelInsertionOptions& options)
{
  const BeamVoxels voxels(tree, beams);
  const float threshold = tree.getOccupancyThresLog();
  options.applyTo(tree);
  const bool lazy = !options.pruning;  // a lazy insertion leaves the tree unpruned
  // what an insertion that failed half way has changed stays noted
  tree.enableChangeDetection(true);
  voxels.insertInto(tree, lazy);
  if (lazy) tree.updateInnerOccupancy();
  auto changed = changedColumns(tree);
  // another threshold can change any voxel's state
  if (threshold != tree.getOccupancyThresLog())
    changed = allColumns(OctreeSource<octomap::OcTree>(tree));
  return changed;
}

ColumnSet insertBeams(VoxelGrid& grid, const ScanBeams& beams,
                      const TVoxelInsertionOptions& options, int threads)
{
  MemoryBudget budget(grid, options.maxMemory);
  const BeamMask mask(beams, budget, threads);
  requireMemory(grid, mask.bytesFor(grid), options.maxMemory);
  const OccupancyModel model(options);
  const float threshold = grid.occupiedFrom();
  grid.setOccupiedFrom(model.occupiedFrom);
  auto changed = mask.update(grid, model, threads);
  if (threshold != model.occupiedFrom) changed = allColumns(VoxelGridSource(grid));
  return changed;
}

ColumnSet insertScan(octomap::OcTree& tree, const observation::SensorPoints& scan,
                     const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings)
{
  return insertBeams(tree, beamsOf(tree.getResolution(), scan, options, warnings), options);
}

ColumnSet insertScan(VoxelGrid& grid, const observation::SensorPoints& scan,
                     const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings,
                     int threads)
{
  return insertBeams(grid, beamsOf(grid.resolution(), scan, options, warnings), options, threads);
}

namespace
{
/** \param insert inserts the points of one scan and returns the changed columns */
template <class Insert>
InsertedScans insertAll(const std::vector<observation::PosedObservation>& scans,
                        const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings,
                        const std::function<void(double)>& progress, const Insert& insert)
{
  InsertedScans inserted;
  std::size_t count = 0;
  observation::SensorPoints scan;
  for (const auto& posed : scans)
  {
    if (progress) progress(static_cast<double>(count++) / static_cast<double>(scans.size()));
    if (!options.insert2D && !observation::is3DScan(*posed.observation)) continue;
    try
    {
      if (!observation::sensorPoints(*posed.observation, posed.robotPose, scan, warnings)) continue;
      if (scan.empty()) continue;
      inserted.changed.insert(insert(scan));
      ++inserted.scans;
      inserted.points += scan.points.size();
    }
    catch (const std::runtime_error& error)
    {
      throw std::runtime_error("scan " + std::to_string(count) + " of " +
                               std::to_string(scans.size()) + ": " + params::oneLine(error));
    }
  }
  return inserted;
}
}  // namespace

InsertedScans insertScans(octomap::OcTree& tree,
                          const std::vector<observation::PosedObservation>& scans,
                          const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings,
                          const std::function<void(double)>& progress)
{
  return insertAll(scans, options, warnings, progress,
                   [&](const observation::SensorPoints& scan)
                   { return insertScan(tree, scan, options, warnings); });
}

InsertedScans insertScans(VoxelMap& map, const std::vector<observation::PosedObservation>& scans,
                          const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings,
                          const std::function<void(double)>& progress, int threads)
{
  return insertAll(scans, options, warnings, progress,
                   [&](const observation::SensorPoints& scan)
                   { return map.insertScan(scan, options, warnings, {}, threads); });
}

}  // namespace mrpt_mapconv::voxel
