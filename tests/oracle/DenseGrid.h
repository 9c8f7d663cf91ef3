#pragma once

#include <mrpt_mapconv/voxel/RayInsertion.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "RayOracle.h"

namespace mrpt_mapconv::oracle
{
/** voxel::insertRays() into a plain array, one ray and one voxel after the other. */
class DenseGrid
{
 public:
  DenseGrid(double resolution, const KeyBox& box);

  /** \exception std::out_of_range for a ray that leaves the box */
  void insert(const std::vector<voxel::Ray>& rays, const voxel::RayParams& params);

  std::size_t rays = 0, notFinite = 0, updates = 0;  //!< of all insertions

  /** None if it was never touched. */
  const std::optional<float>& at(const voxel::VoxelKey& voxel) const
  {
    return m_voxels.at(indexOf(voxel));
  }
  const KeyBox& box() const { return m_box; }

 private:
  std::size_t indexOf(const voxel::VoxelKey& voxel) const;
  void update(const voxel::VoxelKey& voxel, double probability, const voxel::RayParams& params);

  double m_resolution;
  KeyBox m_box;
  std::vector<std::optional<float>> m_voxels;
};

}  // namespace mrpt_mapconv::oracle
