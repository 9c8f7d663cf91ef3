#pragma once

#include <mrpt_mapconv/params/ListedOptions.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::voxel
{
/** What scans are inserted into; the voxels are the same. */
enum class VoxelEngine : std::uint8_t
{
  Octomap,  //!< an octree, by OctoMap
  Blocks    //!< blocks of voxels, see VoxelGrid: many times as fast
};
inline const std::vector<std::string>& namesOf(VoxelEngine)
{
  static const std::vector<std::string> names{"octomap", "blocks"};
  return names;
}

/** How scans are inserted into the voxel map; named, also in an ini file, as
 * mrpt::maps::COctoMap::TInsertionOptions, with the same defaults, plus insert2D, voxelEngine and
 * maxMemory. */
struct TVoxelInsertionOptions : public params::ListedOptions<TVoxelInsertionOptions>
{
  static constexpr const char* kName = "TVoxelInsertionOptions";
  static constexpr const char* kStreamName = "voxel insertion options";
  static constexpr std::uint8_t kStreamVersion = 1;

  double maxrange = -1;              //!< longest part of a beam to insert [m]; −1: all of it
  bool pruning = true;               //!< keep the tree pruned (lossless)
  double occupancyThres = 0.5;       //!< probability from which on a voxel is occupied
  double probHit = 0.7;              //!< sensor model: probability of a hit
  double probMiss = 0.4;             //!< sensor model: probability of a miss
  double clampingThresMin = 0.1192;  //!< lowest probability of a voxel
  double clampingThresMax = 0.971;   //!< highest probability of a voxel
  bool insert2D = true;              //!< insert 2D range scans, too
  VoxelEngine voxelEngine = VoxelEngine::Blocks;
  /** Of the voxel map, as blocks [MB]; none: three quarters of the machine's. */
  std::optional<std::int32_t> maxMemory = {};

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
    v("voxelEngine", o.voxelEngine, "",
      "what scans are inserted into: blocks, or octomap, which gives the same voxels and takes "
      "many "
      "times as long",
      params::since(1));
    v("maxMemory", o.maxMemory, "MB",
      "largest voxel map in blocks; auto = three quarters of the machine's memory",
      params::since(1));
  }
  /** \exception std::invalid_argument naming the option, its value and what would be right; also
   * for options that exclude each other: no voxel could be occupied, or none free */
  void check() const;

  /** Gives the tree this sensor model (the five probabilities). */
  void applyTo(octomap::OcTree& tree) const;
  /** Takes over the sensor model of other options. */
  void adoptModel(const TVoxelInsertionOptions& o);
  /** Takes over a tree's sensor model. */
  void adoptFrom(const octomap::OcTree& tree);

 private:
  void checkTogether() const;
};

}  // namespace mrpt_mapconv::voxel
