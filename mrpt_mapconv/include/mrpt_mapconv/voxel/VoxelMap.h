#pragma once

#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::voxel
{
struct ScanBeams;

/** A voxel map that scans are inserted into: bricks (VoxelGrid) or an octree, as
 * TVoxelInsertionOptions::voxelEngine says. Each is made of the other when it is needed; both hold
 * the same voxels.
 *
 * Const functions may be called by several threads at once. */
class VoxelMap
{
 public:
  /** An empty map. \param resolution size of a voxel [m]
   * \exception std::invalid_argument unless it is 0.0001 to 1000 m */
  explicit VoxelMap(double resolution);
  ~VoxelMap();
  VoxelMap(const VoxelMap& o);
  VoxelMap& operator=(const VoxelMap& o);
  VoxelMap(VoxelMap&& o) noexcept;
  VoxelMap& operator=(VoxelMap&& o) noexcept;

  double resolution() const { return m_resolution; }
  /** Whether no voxel is known. */
  bool empty() const;
  /** How many voxels are known. */
  std::size_t size() const;
  /** Whether any voxel is free. */
  bool hasFree() const { return hasFreeVoxel(*source()); }
  /** What the map is read through, until it changes. */
  std::unique_ptr<VoxelSource> source() const;
  /** The map as an octree with the sensor model of model(). It is made when it is first asked for,
   * and kept until the map changes: then the reference is no longer valid.
   * \exception std::runtime_error if the map reaches beyond an octree's range of ±32768 voxels */
  const octomap::OcTree& octree() const;
  /** The bytes of an `.ot` file of octree(), which need not be made for that. */
  std::string fullOctree() const;
  /** Writes octree() as a `.bt` file, see writeOctreeFile(). */
  void writeOctreeFile(const std::string& path) const;

  /** The sensor model of the last insertion, or that which came with an octree; the five
   * probabilities count, and whether octree() is pruned: one that was once stays so. */
  const TVoxelInsertionOptions& model() const { return m_model; }
  /** Sets it, and with it from which probability on voxels are occupied; a map that came as an
   * octree stays pruned, or not, as it is. */
  void setModel(const TVoxelInsertionOptions& model);

  /** Replaces the map, its resolution, and its model by a tree's.
   * \exception std::invalid_argument for none, or one of a resolution that the constructor refuses
   */
  void setOctree(std::unique_ptr<octomap::OcTree> tree);
  /** Replaces the map by the bytes of an `.ot` file of an OcTree; the model stays.
   * \param resolution if a file's was rounded to fewer digits
   * \param maxMemory of the grid [MB]; none: three quarters of the machine's
   * \exception std::runtime_error as readVoxelGrid(); the map then stays as it was */
  void setFullOctree(std::string_view bytes, const std::string& name, double resolution,
                     const std::optional<std::int32_t>& maxMemory = {});
  /** Replaces the map, its resolution, and its model. */
  void setGrid(VoxelGrid grid, const TVoxelInsertionOptions& model);
  /** Makes all voxels unknown. */
  void clear();

  /** Inserts a scan: free along each beam, occupied at its end if something returned from there;
   * each voxel at most once.
   * \param check called with the columns of the sensor and of the ends of the beams before anything
   * is changed; it may throw
   * \param warnings told of points that lie outside the range of ±32768 voxels (left out)
   * \param threads 0 = all cores
   * \return the columns in which a voxel has become known or has changed between free and occupied
   * \exception std::invalid_argument for options that are not valid
   * \exception std::runtime_error for a sensor pose that is not finite or outside the range, or if
   * the map would exceed maxMemory; the map then stays as it was */
  ColumnSet insertScan(const observation::SensorPoints& scan, const TVoxelInsertionOptions& options,
                       observation::SayOnceLog* warnings = nullptr,
                       const std::function<void(const grid::GridFrame&)>& check = {},
                       int threads = 0);

 private:
  ColumnSet insertIntoGrid(const ScanBeams& beams, const TVoxelInsertionOptions& options,
                           int threads);
  ColumnSet insertIntoOctree(const ScanBeams& beams, const TVoxelInsertionOptions& options);

  double m_resolution;
  TVoxelInsertionOptions m_model;
  std::optional<VoxelGrid> m_grid;                  //!< if it is there, it is what counts
  mutable std::unique_ptr<octomap::OcTree> m_tree;  //!< what counts, or made of the grid
  mutable std::mutex m_making;                      //!< m_tree
};

}  // namespace mrpt_mapconv::voxel
