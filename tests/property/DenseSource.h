#pragma once

#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <algorithm>
#include <optional>

#include "../oracle/DenseMap.h"

namespace mrpt_mapconv::test
{
/** An array of voxels as a map to be converted; follows whatever happens to the array. */
class DenseSource : public voxel::VoxelSource
{
 public:
  explicit DenseSource(const oracle::DenseMap& map) : m_map(map) {}
  double resolution() const override { return m_map.resolution; }
  std::optional<voxel::KeyRect> bounds() const override;
  void read(voxel::ColumnBlock& block) const override;

 private:
  const oracle::DenseMap& m_map;
};

/** The part of an array that holds all known voxels, of which there must be one. */
oracle::DenseMap trimmed(const oracle::DenseMap& map);

}  // namespace mrpt_mapconv::test
