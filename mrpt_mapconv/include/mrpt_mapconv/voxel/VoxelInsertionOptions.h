#pragma once

#include <mrpt_mapconv/params/ListedOptions.h>

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::voxel
{
/** How scans are inserted into the voxel map; named, also in an ini file, as
 * mrpt::maps::COctoMap::TInsertionOptions, with the same defaults, plus insert2D. */
struct TVoxelInsertionOptions : public params::ListedOptions<TVoxelInsertionOptions>
{
  static constexpr const char* kName = "TVoxelInsertionOptions";
  static constexpr const char* kStreamName = "voxel insertion options";
  static constexpr std::uint8_t kStreamVersion = 0;

  double maxrange = -1;              //!< longest part of a beam to insert [m]; −1: all of it
  bool pruning = true;               //!< keep the tree pruned (lossless)
  double occupancyThres = 0.5;       //!< probability from which on a voxel is occupied
  double probHit = 0.7;              //!< sensor model: probability of a hit
  double probMiss = 0.4;             //!< sensor model: probability of a miss
  double clampingThresMin = 0.1192;  //!< lowest probability of a voxel
  double clampingThresMax = 0.971;   //!< highest probability of a voxel
  bool insert2D = true;              //!< insert 2D range scans, too

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    v("maxrange", o.maxrange, "m", "longest part of a beam that is inserted; -1 = all of it");
    v("pruning", o.pruning, "", "keep the voxel map pruned (lossless)");
    v("occupancyThres", o.occupancyThres, "", "probability from which on a voxel is occupied");
    v("probHit", o.probHit, "", "probability that stands for a hit, 0.5 to 1");
    v("probMiss", o.probMiss, "", "probability that stands for a miss, 0 to 0.5");
    v("clampingThresMin", o.clampingThresMin, "", "lowest probability of a voxel");
    v("clampingThresMax", o.clampingThresMax, "", "highest probability of a voxel");
    v("insert2D", o.insert2D, "", "insert 2D range scans, too");
  }
  /** \exception std::invalid_argument naming the option, its value and what would be right; also
   * for options that exclude each other: no voxel could be occupied, or none free */
  void check() const;

  /** Gives the tree this sensor model (the five probabilities). */
  void applyTo(octomap::OcTree& tree) const;
  /** Takes over a tree's sensor model. */
  void adoptFrom(const octomap::OcTree& tree);

 private:
  void checkTogether() const;
};

}  // namespace mrpt_mapconv::voxel
