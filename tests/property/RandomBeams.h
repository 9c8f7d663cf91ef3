#pragma once

#include <mrpt_mapconv/observation/SensorPoints.h>
#include <mrpt_mapconv/voxel/RegionTable.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>

#include <string>

#include "RandomMap.h"

namespace mrpt_mapconv::test
{
/** Scans of a sensor that stays in one part of a voxel map: near its origin, far from it or at the
 * end of an octree's range. */
class RandomBeams
{
 public:
  explicit RandomBeams(Rng& rng);

  double resolution() const { return m_resolution; }
  /** The voxel around which the sensor is. */
  voxel::VoxelKey home() const { return {m_x, m_y, m_z}; }
  /** From a place within a voxel, on a face or in a corner. Beams lie along axes and diagonals, end
   * on faces, in the sensor's own voxel, where another one ended or outside the range.
   * \param beams how many, with and without return together */
  observation::SensorPoints scan(int beams);
  std::string text() const;

 private:
  mrpt::poses::CPose3D pose();
  float coordinate(int key);
  mrpt::math::TPoint3Df outside();
  mrpt::math::TPoint3Df point(const mrpt::poses::CPose3D& sensor,
                              const std::vector<mrpt::math::TPoint3Df>& before);

  Rng& m_rng;
  double m_resolution;
  int m_x, m_y, m_z;  //!< keys around which the sensor is
};

/** Options that check() allows: often the default sensor model, else one of values that include the
 * extreme ones; some with a maximum range of a few voxels. */
voxel::TVoxelInsertionOptions randomInsertion(Rng& rng, double resolution);
/** The same without those with which log-odds can be infinite: files hold no such. */
voxel::TVoxelInsertionOptions finiteInsertion(Rng& rng, double resolution);

/** Adds cubes of 1 to 32 voxels to a side around a voxel, some with log-odds that no sensor model
 * would give. */
void addCubes(Rng& rng, const voxel::VoxelKey& around, octomap::OcTree& tree);

std::string text(const voxel::TVoxelInsertionOptions& options);

}  // namespace mrpt_mapconv::test
