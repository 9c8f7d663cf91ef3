#pragma once

#include <mrpt_mapconv/voxel/VoxelGrid.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <cstdint>
#include <optional>

namespace mrpt_mapconv::voxel
{
/** Reads a VoxelGrid: a touched voxel is occupied from VoxelGrid::occupiedFrom() on, else free. The
 * grid must outlive the source; once it has changed, another source has to be made of it. */
class VoxelGridSource : public VoxelSource
{
 public:
  explicit VoxelGridSource(const VoxelGrid& grid);
  double resolution() const override { return m_grid.resolution(); }
  /** \exception std::runtime_error for a map that is 2^31 voxels wide or more */
  std::optional<KeyRect> bounds() const override;
  void read(ColumnBlock& block) const override;
  std::optional<std::int32_t> top() const override;

 private:
  const VoxelGrid& m_grid;
  std::int32_t m_zMin, m_zMax;  //!< of the regions' keys
};

}  // namespace mrpt_mapconv::voxel
