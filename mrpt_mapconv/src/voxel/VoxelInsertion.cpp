#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "BeamVoxels.h"

namespace mrpt_mapconv::voxel
{
namespace
{
constexpr std::int32_t kKeyOffset = voxel::kOctomapKeyOffset;

octomap::point3d toOctomap(double x, double y, double z)
{
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

octomap::point3d originOf(const observation::SensorPoints& scan)
{
  return toOctomap(scan.sensorPose.x(), scan.sensorPose.y(), scan.sensorPose.z());
}

/** Where the part of a beam that is inserted ends; nothing if that is outside the tree. */
std::optional<octomap::OcTreeKey> endKey(const octomap::OcTree& tree,
                                         const octomap::point3d& origin,
                                         const octomap::point3d& end, double maxRange)
{
  octomap::OcTreeKey key;
  const octomap::point3d beam = end - origin;
  const double length = beam.norm();
  const bool whole = maxRange <= 0 || length <= maxRange;
  const auto last = whole ? end : origin + beam * static_cast<float>(maxRange / length);
  if (!tree.coordToKeyChecked(last, key)) return std::nullopt;
  return key;
}

octomap::point3d inMap(const observation::SensorPoints& scan, const mrpt::math::TPoint3Df& point)
{
  double x = 0, y = 0, z = 0;
  scan.sensorPose.composePoint(point.x, point.y, point.z, x, y, z);
  return toOctomap(x, y, z);
}

/** The sensor's key.
 * \exception std::runtime_error if its pose is not finite or outside the tree's range */
octomap::OcTreeKey sensorKey(const octomap::OcTree& tree, const observation::SensorPoints& scan)
{
  octomap::OcTreeKey key;
  if (!observation::isFinite(scan.sensorPose) || !tree.coordToKeyChecked(originOf(scan), key))
    throw std::runtime_error("sensor pose " + scan.sensorPose.asString() +
                             " is not finite or outside the voxel map's range");
  return key;
}

/** The beams of a scan that stay in the tree, by their ends in the map frame. */
struct Beams
{
  octomap::Pointcloud hits, misses;  // misses: beams without return
};

Beams beamsOf(const octomap::OcTree& tree, const observation::SensorPoints& scan,
              const octomap::point3d& origin, double maxRange, observation::SayOnceLog* warnings)
{
  Beams beams;
  std::size_t outside = 0;
  const auto add = [&](const std::vector<mrpt::math::TPoint3Df>& points, octomap::Pointcloud& ends)
  {
    ends.reserve(points.size());
    for (const auto& point : points)
    {
      const auto end = inMap(scan, point);
      if (endKey(tree, origin, end, maxRange))
        ends.push_back(end);
      else
        ++outside;
    }
  };
  add(scan.points, beams.hits);
  add(scan.noReturns, beams.misses);
  if (outside && warnings)
    warnings->warn(std::to_string(outside) +
                   " points left out: farther from the map's origin than " +
                   std::to_string(kKeyOffset * tree.getResolution()) +
                   " m, the reach of a tree of this resolution");
  return beams;
}

voxel::ColumnSet changedColumns(octomap::OcTree& tree)
{
  voxel::ColumnSet columns;
  for (auto it = tree.changedKeysBegin(); it != tree.changedKeysEnd(); ++it)
    columns.insert(it->first[0] - kKeyOffset, it->first[1] - kKeyOffset);
  tree.resetChangeDetection();
  return columns;
}
voxel::ColumnSet allColumns(const octomap::OcTree& tree)
{
  const auto box = voxel::OctreeSource<octomap::OcTree>(tree).bounds();
  if (!box) return {};
  return voxel::ColumnSet::of(voxel::frameOf(*box, tree.getResolution()));
}
}  // namespace

grid::GridFrame frameOfScan(const octomap::OcTree& tree, const observation::SensorPoints& scan,
                            const TVoxelInsertionOptions& options)
{
  const auto at = [&](const octomap::OcTreeKey& key) {
    return grid::GridFrame{tree.getResolution(), key[0] - kKeyOffset, key[1] - kKeyOffset, 1, 1};
  };
  const auto origin = originOf(scan);
  grid::GridFrame frame = at(sensorKey(tree, scan));
  for (const auto* points : {&scan.points, &scan.noReturns})
    for (const auto& point : *points)
      if (const auto key = endKey(tree, origin, inMap(scan, point), options.maxrange))
        if (!frame.containsKey((*key)[0] - kKeyOffset, (*key)[1] - kKeyOffset))
          frame = unite(frame, at(*key));
  return frame;
}

voxel::ColumnSet insertScan(octomap::OcTree& tree, const observation::SensorPoints& scan,
                            const TVoxelInsertionOptions& options,
                            observation::SayOnceLog* warnings)
{
  const auto origin = originOf(scan);
  sensorKey(tree, scan);  // checks it
  const Beams beams = beamsOf(tree, scan, origin, options.maxrange, warnings);

  const BeamVoxels voxels(tree, beams.hits, beams.misses, origin, options.maxrange);
  const float threshold = tree.getOccupancyThresLog();
  options.applyTo(tree);
  const bool lazy = !options.pruning;  // a lazy insertion leaves the tree unpruned
  // what an insertion that failed half way has changed stays noted
  tree.enableChangeDetection(true);
  voxels.insertInto(tree, lazy);
  if (lazy) tree.updateInnerOccupancy();
  auto changed = changedColumns(tree);
  // another threshold can change any voxel's state
  if (threshold != tree.getOccupancyThresLog()) changed = allColumns(tree);
  return changed;
}

InsertedScans insertScans(octomap::OcTree& tree,
                          const std::vector<observation::PosedObservation>& scans,
                          const TVoxelInsertionOptions& options, observation::SayOnceLog* warnings,
                          const std::function<void(double)>& progress)
{
  InsertedScans inserted;
  std::size_t count = 0;
  for (const auto& posed : scans)
  {
    if (progress) progress(static_cast<double>(count++) / static_cast<double>(scans.size()));
    if (!options.insert2D && !observation::is3DScan(*posed.observation)) continue;
    try
    {
      const auto scan = observation::sensorPoints(*posed.observation, posed.robotPose, warnings);
      if (!scan || scan->empty()) continue;
      inserted.changed.insert(insertScan(tree, *scan, options, warnings));
      ++inserted.scans;
      inserted.points += scan->points.size();
    }
    catch (const std::runtime_error& error)
    {
      throw std::runtime_error("scan " + std::to_string(count) + " of " +
                               std::to_string(scans.size()) + ": " + params::oneLine(error));
    }
  }
  return inserted;
}

}  // namespace mrpt_mapconv::voxel
