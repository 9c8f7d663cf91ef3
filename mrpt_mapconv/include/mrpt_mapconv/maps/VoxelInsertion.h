#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/maps/ObservationPoints.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::maps
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
  /** \exception std::exception for a stream that does not hold valid options */
  void readFromStream(mrpt::serialization::CArchive& in);

  /** Gives the tree this sensor model. */
  void applyTo(octomap::OcTree& tree) const;
};

/** The frame that holds everything a scan can change: its sensor and the ends of its beams, as far
 * as they lie in the tree. */
grid::GridFrame frameOfScan(const octomap::OcTree& tree, const SensorPoints& scan,
                            const TVoxelInsertionOptions& options);

/** Inserts a scan into a voxel map: free along each beam, occupied at its end.
 *
 * \param scan its points and the pose of the sensor in the map
 * \param warnings told of points that lie outside the tree's range of ±32768 voxels (left out)
 * \return the columns in which a voxel has become known or has changed between free and occupied
 * \exception std::runtime_error for a sensor pose that is not finite or outside the tree's range;
 * the tree then stays as it was */
voxel::ColumnSet insertScan(octomap::OcTree& tree, const SensorPoints& scan,
                            const TVoxelInsertionOptions& options,
                            PointWarnings* warnings = nullptr);

}  // namespace mrpt_mapconv::maps
