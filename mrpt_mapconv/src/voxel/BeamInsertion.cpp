#include "BeamInsertion.h"

#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelGridSource.h>
#include <octomap/OcTree.h>

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
  reserveMemory(grid, mask.bytesFor(grid), options.maxMemory);
  const OccupancyModel model(options);
  const float threshold = grid.occupiedFrom();
  grid.setOccupiedFrom(model.occupiedFrom);
  auto changed = mask.update(grid, model, threads);
  if (threshold != model.occupiedFrom) changed = allColumns(VoxelGridSource(grid));
  return changed;
}

}  // namespace mrpt_mapconv::voxel
