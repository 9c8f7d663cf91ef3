#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/maps/PoseTrack.h>
#include <mrpt_mapconv/maps/StrictSection.h>
#include <mrpt_mapconv/maps/VoxelInsertion.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::maps
{
namespace
{
constexpr std::uint8_t kStreamVersion = 0;
constexpr std::int32_t kKeyOffset = 32768;  // OctoMap's key of coordinate 0

void require(bool ok, const char* name, double value, const char* right)
{
  if (ok) return;
  std::ostringstream message;
  message << name << " = " << value << " is not valid: it must be " << right;
  throw std::invalid_argument(message.str());
}

bool isProbability(double p) { return p > 0 && p < 1; }

octomap::point3d toOctomap(const mrpt::math::TPoint3D& p)
{
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
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

octomap::point3d inMap(const SensorPoints& scan, const mrpt::math::TPoint3Df& point)
{
  return toOctomap(scan.sensorPose.composePoint(mrpt::math::TPoint3D(point)));
}

/** The sensor's key.
 * \exception std::runtime_error if its pose is not finite or outside the tree's range */
octomap::OcTreeKey sensorKey(const octomap::OcTree& tree, const SensorPoints& scan)
{
  octomap::OcTreeKey key;
  if (!isFinite(scan.sensorPose) ||
      !tree.coordToKeyChecked(toOctomap(scan.sensorPose.translation()), key))
    throw std::runtime_error("sensor pose " + scan.sensorPose.asString() +
                             " is not finite or outside the voxel map's range");
  return key;
}

/** The scan's points in the map frame, without those whose beams leave the tree. */
octomap::Pointcloud toCloud(const octomap::OcTree& tree, const SensorPoints& scan,
                            const octomap::point3d& origin, double maxRange,
                            PointWarnings* warnings)
{
  octomap::Pointcloud cloud;
  cloud.reserve(scan.points.size());
  std::size_t outside = 0;
  for (const auto& point : scan.points)
  {
    const auto end = inMap(scan, point);
    if (endKey(tree, origin, end, maxRange))
      cloud.push_back(end);
    else
      ++outside;
  }
  if (outside && warnings)
    warnings->warn(std::to_string(outside) +
                   " points left out: farther from the map's origin than " +
                   std::to_string(kKeyOffset * tree.getResolution()) +
                   " m, the reach of a tree of this resolution");
  return cloud;
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
  return voxel::ColumnSet::of({tree.getResolution(), box->xMin, box->yMin,
                               box->xMax - box->xMin + 1, box->yMax - box->yMin + 1});
}
}  // namespace

void TVoxelInsertionOptions::check() const
{
  require(std::isfinite(maxrange) && (maxrange > 0 || maxrange == -1), "maxrange", maxrange,
          "a range > 0 m, or -1 for no limit");
  require(isProbability(occupancyThres), "occupancyThres", occupancyThres, "within (0, 1)");
  require(isProbability(probHit) && probHit >= 0.5, "probHit", probHit, "within [0.5, 1)");
  require(isProbability(probMiss) && probMiss <= 0.5, "probMiss", probMiss, "within (0, 0.5]");
  require(isProbability(clampingThresMin), "clampingThresMin", clampingThresMin, "within (0, 1)");
  require(isProbability(clampingThresMax) && clampingThresMax > clampingThresMin,
          "clampingThresMax", clampingThresMax, "above clampingThresMin and below 1");
}

void TVoxelInsertionOptions::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                                const std::string& section)
{
  TVoxelInsertionOptions read = *this;
  StrictSection ini(source, section);
  ini.read("maxrange", read.maxrange);
  ini.read("pruning", read.pruning);
  ini.read("occupancyThres", read.occupancyThres);
  ini.read("probHit", read.probHit);
  ini.read("probMiss", read.probMiss);
  ini.read("clampingThresMin", read.clampingThresMin);
  ini.read("clampingThresMax", read.clampingThresMax);
  ini.read("insert2D", read.insert2D);
  try
  {
    read.check();
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("section '" + section + "': " + error.what());
  }
  ini.warnUnknown();
  *this = read;
}

void TVoxelInsertionOptions::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                                              const std::string& section) const
{
  target.write(section, "maxrange", maxrange);
  target.write(section, "pruning", pruning);
  target.write(section, "occupancyThres", occupancyThres);
  target.write(section, "probHit", probHit);
  target.write(section, "probMiss", probMiss);
  target.write(section, "clampingThresMin", clampingThresMin);
  target.write(section, "clampingThresMax", clampingThresMax);
  target.write(section, "insert2D", insert2D);
}

void TVoxelInsertionOptions::dumpToTextStream(std::ostream& out) const
{
  out << "\n----------- [mrpt_mapconv TVoxelInsertionOptions] ------------ \n\n";
  dumpVar_double(out, "maxrange", maxrange);
  dumpVar_bool(out, "pruning", pruning);
  dumpVar_double(out, "occupancyThres", occupancyThres);
  dumpVar_double(out, "probHit", probHit);
  dumpVar_double(out, "probMiss", probMiss);
  dumpVar_double(out, "clampingThresMin", clampingThresMin);
  dumpVar_double(out, "clampingThresMax", clampingThresMax);
  dumpVar_bool(out, "insert2D", insert2D);
}

void TVoxelInsertionOptions::writeToStream(mrpt::serialization::CArchive& out) const
{
  out << kStreamVersion << maxrange << pruning << occupancyThres << probHit << probMiss
      << clampingThresMin << clampingThresMax << insert2D;
}

void TVoxelInsertionOptions::readFromStream(mrpt::serialization::CArchive& in)
{
  std::uint8_t version = 0;
  TVoxelInsertionOptions read;
  in >> version;
  if (version != kStreamVersion)
    throw std::runtime_error("voxel insertion options: unknown version " + std::to_string(version));
  in >> read.maxrange >> read.pruning >> read.occupancyThres >> read.probHit >> read.probMiss >>
      read.clampingThresMin >> read.clampingThresMax >> read.insert2D;
  read.check();
  *this = read;
}

void TVoxelInsertionOptions::applyTo(octomap::OcTree& tree) const
{
  tree.setOccupancyThres(occupancyThres);
  tree.setProbHit(probHit);
  tree.setProbMiss(probMiss);
  tree.setClampingThresMin(clampingThresMin);
  tree.setClampingThresMax(clampingThresMax);
}

grid::GridFrame frameOfScan(const octomap::OcTree& tree, const SensorPoints& scan,
                            const TVoxelInsertionOptions& options)
{
  const auto at = [&](const octomap::OcTreeKey& key) {
    return grid::GridFrame{tree.getResolution(), key[0] - kKeyOffset, key[1] - kKeyOffset, 1, 1};
  };
  const auto origin = toOctomap(scan.sensorPose.translation());
  grid::GridFrame frame = at(sensorKey(tree, scan));
  for (const auto& point : scan.points)
    if (const auto key = endKey(tree, origin, inMap(scan, point), options.maxrange))
      if (!frame.containsKey((*key)[0] - kKeyOffset, (*key)[1] - kKeyOffset))
        frame = unite(frame, at(*key));
  return frame;
}

voxel::ColumnSet insertScan(octomap::OcTree& tree, const SensorPoints& scan,
                            const TVoxelInsertionOptions& options, PointWarnings* warnings)
{
  const auto origin = toOctomap(scan.sensorPose.translation());
  sensorKey(tree, scan);  // checks it
  const auto cloud = toCloud(tree, scan, origin, options.maxrange, warnings);

  const float threshold = tree.getOccupancyThresLog();
  options.applyTo(tree);
  const bool lazy = !options.pruning;  // a lazy insertion leaves the tree unpruned
  tree.enableChangeDetection(true);
  tree.resetChangeDetection();
  tree.insertPointCloud(cloud, origin, options.maxrange, lazy);
  if (lazy) tree.updateInnerOccupancy();
  auto changed = changedColumns(tree);
  // another threshold can change any voxel's state
  if (threshold != tree.getOccupancyThresLog()) changed = allColumns(tree);
  return changed;
}

}  // namespace mrpt_mapconv::maps
