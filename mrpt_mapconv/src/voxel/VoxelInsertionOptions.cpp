#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv::voxel
{
using params::require;

namespace
{
bool isProbability(double p) { return p >= 0 && p <= 1; }
}  // namespace

void TVoxelInsertionOptions::check() const
{
  require(std::isfinite(maxrange) && (maxrange > 0 || maxrange == -1), "maxrange", maxrange,
          "a range > 0 m, or -1 for no limit");
  require(isProbability(occupancyThres), "occupancyThres", occupancyThres, "within [0, 1]");
  require(isProbability(probHit) && probHit >= 0.5, "probHit", probHit, "within [0.5, 1]");
  require(isProbability(probMiss) && probMiss <= 0.5, "probMiss", probMiss, "within [0, 0.5]");
  require(isProbability(clampingThresMin), "clampingThresMin", clampingThresMin, "within [0, 1]");
  require(isProbability(clampingThresMax) && clampingThresMax > clampingThresMin,
          "clampingThresMax", clampingThresMax, "above clampingThresMin and at most 1");
}

void TVoxelInsertionOptions::applyTo(octomap::OcTree& tree) const
{
  tree.setOccupancyThres(occupancyThres);
  tree.setProbHit(probHit);
  tree.setProbMiss(probMiss);
  tree.setClampingThresMin(clampingThresMin);
  tree.setClampingThresMax(clampingThresMax);
}

void TVoxelInsertionOptions::adoptFrom(const octomap::OcTree& tree)
{
  occupancyThres = tree.getOccupancyThres();
  probHit = tree.getProbHit();
  probMiss = tree.getProbMiss();
  clampingThresMin = tree.getClampingThresMin();
  clampingThresMax = tree.getClampingThresMax();
}

}  // namespace mrpt_mapconv::voxel
