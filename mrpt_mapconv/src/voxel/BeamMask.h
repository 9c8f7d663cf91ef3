#pragma once

#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <cstddef>
#include <cstdint>
#include <memory>

#include "BrickUpdate.h"
#include "KnownRegions.h"
#include "MemoryLimit.h"
#include "ScanBeams.h"

namespace mrpt_mapconv::voxel
{
/** The voxels that the beams of a scan go through or end in, a bit each: those of
 * octomap::OcTree::computeUpdate(). */
class BeamMask
{
 public:
  /** \param budget for its own bits
   * \param threads that work on it; 0 = all cores
   * \exception std::runtime_error if the budget does not do */
  BeamMask(const ScanBeams& beams, MemoryBudget& budget, int threads);

  /** Bytes by which an update would make a grid larger, at most. */
  std::size_t bytesFor(const VoxelGrid& grid) const;
  /** Updates a grid as octomap::OcTree::insertPointCloud() does a tree: each voxel at most once, a
   * hit where a beam ends, else a miss.
   * \return the columns in which a voxel has become known or has changed between free and occupied
   */
  ColumnSet update(VoxelGrid& grid, const OccupancyModel& model, int threads) const;

 private:
  using Table = RegionTable<std::unique_ptr<BrickBits>>;
  BeamMask(const OctomapKeys& keys, MemoryBudget& budget) : m_keys(keys), m_budget(&budget) {}
  Table::Region& region(const VoxelKey& key);
  BrickBits& bitsOf(Table::Region& region, std::size_t brick);
  void hit(const VoxelKey& voxel);
  void cross(const octomap::point3d& origin, const ScanBeams::Beam& beam, const VoxelKey& from);
  void addShare(const ScanBeams& beams, std::size_t share, std::size_t shares);
  void add(BeamMask&& other);

  OctomapKeys m_keys;
  MemoryBudget* m_budget;
  Table m_table;
  KnownRegions<Table::Region*> m_recent;
};

}  // namespace mrpt_mapconv::voxel
