#include "BeamOracle.h"

#include <iostream>

namespace mrpt_mapconv::oracle
{
namespace
{
/** OctoMap complains of every beam that leaves the tree's range. */
class SilentErrors
{
 public:
  SilentErrors() : m_buffer(std::cerr.rdbuf(nullptr)) {}
  ~SilentErrors()
  {
    std::cerr.rdbuf(m_buffer);
    std::cerr.clear();
  }
  SilentErrors(const SilentErrors&) = delete;
  SilentErrors& operator=(const SilentErrors&) = delete;

 private:
  std::streambuf* m_buffer;
};

octomap::Pointcloud inMap(const mrpt::poses::CPose3D& sensor,
                          const std::vector<mrpt::math::TPoint3Df>& points)
{
  octomap::Pointcloud cloud;
  for (const auto& point : points)
  {
    double x = 0, y = 0, z = 0;
    sensor.composePoint(point.x, point.y, point.z, x, y, z);
    cloud.push_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  }
  return cloud;
}

/** What beams go through and end in. */
struct BeamKeys
{
  octomap::KeySet hits, crossed;
  bool isWrapped = false;  //!< some beam left the range by a rounding error; its rest is left out
};

bool areNeighbours(const octomap::OcTreeKey& a, const octomap::OcTreeKey& b)
{
  for (unsigned i = 0; i < 3; ++i)
    if (std::abs(int{a[i]} - int{b[i]}) > 1) return false;
  return true;
}

/** Takes over the keys up to where they begin anew at the other end of the tree's range. */
void addRay(const octomap::KeyRay& ray, BeamKeys& keys)
{
  for (auto key = ray.begin(); key != ray.end(); ++key)
  {
    if (key != ray.begin() && !areNeighbours(*(key - 1), *key))
    {
      keys.isWrapped = true;
      return;
    }
    keys.crossed.insert(*key);
  }
}

BeamKeys beamKeys(const octomap::OcTree& tree, const octomap::Pointcloud& returns,
                  const octomap::Pointcloud& noReturns, const octomap::point3d& origin,
                  double maxRange)
{
  BeamKeys keys;
  octomap::KeyRay ray;
  for (const auto* cloud : {&returns, &noReturns})
    for (const octomap::point3d& point : *cloud)
    {
      const bool isCut = maxRange >= 0 && (point - origin).norm() > maxRange;
      const octomap::point3d end =
          isCut ? origin + (point - origin).normalized() * static_cast<float>(maxRange) : point;
      octomap::OcTreeKey key;
      if (!tree.coordToKeyChecked(end, key)) continue;
      if (!isCut && cloud == &returns) keys.hits.insert(key);
      if (tree.computeRayKeys(origin, end, ray)) addRay(ray, keys);
    }
  return keys;
}

/** Voxel by voxel; a hit wins over any number of misses. */
void insertKeys(octomap::OcTree& tree, const BeamKeys& keys, bool lazy)
{
  for (const auto& key : keys.crossed)
    if (keys.hits.count(key) == 0) tree.updateNode(key, false, lazy);
  for (const auto& key : keys.hits) tree.updateNode(key, true, lazy);
}
}  // namespace

void insertScan(octomap::OcTree& tree, const observation::SensorPoints& scan,
                const voxel::TVoxelInsertionOptions& options)
{
  const SilentErrors silent;
  const auto& pose = scan.sensorPose;
  const octomap::point3d origin(static_cast<float>(pose.x()), static_cast<float>(pose.y()),
                                static_cast<float>(pose.z()));
  const auto returns = inMap(pose, scan.points);
  const bool lazy = !options.pruning;
  options.applyTo(tree);
  const auto keys = beamKeys(tree, returns, inMap(pose, scan.noReturns), origin, options.maxrange);
  if (scan.noReturns.empty() && !keys.isWrapped)
    tree.insertPointCloud(returns, origin, options.maxrange, lazy);
  else
    insertKeys(tree, keys, lazy);
  if (lazy) tree.updateInnerOccupancy();
}

}  // namespace mrpt_mapconv::oracle
