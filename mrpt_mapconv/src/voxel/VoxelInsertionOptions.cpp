#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace mrpt_mapconv::voxel
{
using params::require;

namespace
{
bool isProbability(double p) { return p >= 0 && p <= 1; }

/** What another option asks of a value, and what would be without it. */
std::string beside(const char* right, const char* key, double value, const char* otherwise)
{
  std::ostringstream text;
  text << right << " " << key << " = " << value << ", else " << otherwise;
  return text.str();
}
}  // namespace

void TVoxelInsertionOptions::check() const
{
  require(std::isfinite(maxrange) && (maxrange > 0 || maxrange == -1), "maxrange", maxrange,
          "a range > 0 m, or -1 for no limit");
  require(occupancyThres > 0 && occupancyThres < 1, "occupancyThres", occupancyThres,
          "above 0 and below 1");
  require(isProbability(probHit) && probHit >= 0.5, "probHit", probHit, "within [0.5, 1]");
  require(isProbability(probMiss) && probMiss <= 0.5, "probMiss", probMiss, "within [0, 0.5]");
  require(isProbability(clampingThresMin), "clampingThresMin", clampingThresMin, "within [0, 1]");
  require(isProbability(clampingThresMax) && clampingThresMax > clampingThresMin,
          "clampingThresMax", clampingThresMax, "above clampingThresMin and at most 1");
  require(!maxMemory || *maxMemory > 0, "maxMemory", maxMemory.value_or(0), "above 0 MB, or auto");
  checkTogether();
}

/** Values that are good each, but with which no voxel could ever be occupied, or none free. */
void TVoxelInsertionOptions::checkTogether() const
{
  require(clampingThresMax >= occupancyThres, "clampingThresMax", clampingThresMax,
          beside("at least", "occupancyThres", occupancyThres, "no voxel could ever be occupied"));
  require(clampingThresMin < occupancyThres, "clampingThresMin", clampingThresMin,
          beside("below", "occupancyThres", occupancyThres, "no voxel could ever be free"));
  require(probHit <= clampingThresMax, "probHit", probHit,
          beside("at most", "clampingThresMax", clampingThresMax, "no voxel can be that probable"));
  require(
      probMiss >= clampingThresMin, "probMiss", probMiss,
      beside("at least", "clampingThresMin", clampingThresMin, "no voxel can be that improbable"));
  // a voxel that was never seen is at 0.5
  require(probHit > 0.5 || occupancyThres <= 0.5, "probHit", probHit,
          beside("above 0.5 with", "occupancyThres", occupancyThres,
                 "no voxel could ever be occupied"));
  require(probMiss < 0.5 || occupancyThres > 0.5, "probMiss", probMiss,
          beside("below 0.5 with", "occupancyThres", occupancyThres,
                 "what beams go through would be occupied"));
}

void TVoxelInsertionOptions::applyTo(octomap::OcTree& tree) const
{
  tree.setOccupancyThres(occupancyThres);
  tree.setProbHit(probHit);
  tree.setProbMiss(probMiss);
  tree.setClampingThresMin(clampingThresMin);
  tree.setClampingThresMax(clampingThresMax);
}

void TVoxelInsertionOptions::adoptModel(const TVoxelInsertionOptions& o)
{
  occupancyThres = o.occupancyThres;
  probHit = o.probHit;
  probMiss = o.probMiss;
  clampingThresMin = o.clampingThresMin;
  clampingThresMax = o.clampingThresMax;
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
