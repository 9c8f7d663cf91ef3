#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <mrpt/serialization/CArchive.h>

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::voxel
{
/** How scans are inserted into the voxel map; named, also in an ini file, as
 * mrpt::maps::COctoMap::TInsertionOptions, with the same defaults, plus insert2D. */
struct TVoxelInsertionOptions : public mrpt::config::CLoadableOptions
{
  double maxrange = -1;              //!< longest part of a beam to insert [m]; −1: all of it
  bool pruning = true;               //!< keep the tree pruned (lossless)
  double occupancyThres = 0.5;       //!< probability from which on a voxel is occupied
  double probHit = 0.7;              //!< sensor model: probability of a hit
  double probMiss = 0.4;             //!< sensor model: probability of a miss
  double clampingThresMin = 0.1192;  //!< lowest probability of a voxel
  double clampingThresMax = 0.971;   //!< highest probability of a voxel
  bool insert2D = true;              //!< insert 2D range scans, too

  /** \exception std::invalid_argument naming the option, its value and what would be right */
  void check() const;

  /** Reads the keys that are there; warns about others.
   * \exception std::runtime_error naming section, key and value; the options then stay as they were
   */
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                          const std::string& section) override;
  void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                        const std::string& section) const override;
  void dumpToTextStream(std::ostream& out) const override;

  void writeToStream(mrpt::serialization::CArchive& out) const;
  /** Values are not checked: a stream brings back what was written, valid or not.
   * \exception std::exception for a stream that ends or does not hold options */
  void readFromStream(mrpt::serialization::CArchive& in);

  /** Gives the tree this sensor model (the five probabilities). */
  void applyTo(octomap::OcTree& tree) const;
  /** Takes over a tree's sensor model. */
  void adoptFrom(const octomap::OcTree& tree);
};

}  // namespace mrpt_mapconv::voxel
