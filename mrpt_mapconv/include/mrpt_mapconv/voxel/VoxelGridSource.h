#pragma once

#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <unordered_map>
#include <vector>

namespace mrpt_mapconv::voxel
{
/** Reads a VoxelGrid: a touched voxel is occupied from VoxelGrid::occupiedFrom() on, else free. The
 * grid must outlive the source; once it has changed, another source has to be made of it. */
class VoxelGridSource : public VoxelSource
{
 public:
  explicit VoxelGridSource(const VoxelGrid& grid);
  double resolution() const override { return m_grid.resolution(); }
  std::optional<KeyRect> bounds() const override;
  void read(ColumnBlock& block) const override;
  std::optional<std::int32_t> top() const override;

 private:
  struct Storey
  {
    std::int32_t z;  //!< of the region's key
    const VoxelGrid::Table::Region* region;
  };
  using Towers = std::unordered_map<BlockKey, std::vector<Storey>, ColumnSet::BlockKeyHash>;

  const VoxelGrid& m_grid;
  Towers m_towers;  //!< regions above each other, from the lowest, by the x and y of their keys
};

}  // namespace mrpt_mapconv::voxel
