#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/OcTree.h>

#include <stdexcept>

#include "BeamInsertion.h"

namespace mrpt_mapconv::voxel
{
ColumnSet insertScan(octomap::OcTree& tree, const observation::SensorPoints& scan,
                     const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings)
{
  options.check();
  return insertBeams(tree, beamsOf(tree.getResolution(), scan, options, warnings), options);
}

ColumnSet insertScan(VoxelGrid& grid, const observation::SensorPoints& scan,
                     const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings,
                     int threads)
{
  options.check();
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
