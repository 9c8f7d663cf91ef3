#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/ConversionOptions.h>
#include <mrpt_mapconv/freespace/LayerScene.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <mrpt_mapconv/voxel/VoxelMapParams.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace mrpt::maps
{
class COctoMap;
}
namespace mrpt::system
{
class CTimeLogger;
}

namespace mrpt_mapconv
{
/** An occupancy grid that is made of a voxel map by free-space projection.
 *
 * The map holds an octree. insertObservation() inserts a scan into it and converts the columns that
 * have changed; the grid that this map *is* always shows the layer for the configured robot, so
 * MRPT's likelihoods, ICP, planners and viewers use it as any other COccupancyGridMap2D. A raw cell
 * is +127 for free, 0 for unknown, −max(1, round(127·value)) for occupied. The grid's frame is that
 * of layers(), whose cells lie on voxel columns. MRPT's particle filter resizes the grid behind the
 * map's back (resizeGrid() is not virtual, and keeps what the cells say): it is laid out anew
 * before the next insertion, matching, saving, copying or step of the filter. MRPT's likelihood
 * cannot be hooked (it is private in the base class): a grid that setSize() has erased is used as
 * it is for likelihoods until then.
 *
 * Observations: see observation::sensorPoints(). Others are ignored.
 *
 * In an ini file, with any prefix that MRPT gives:
 * \code
 * [map]
 * freeSpaceGrid_count = 1
 * [map_freeSpaceGrid_00_creationOpts]
 * resolution = 0.10            // [m] size of voxels and cells
 * [map_freeSpaceGrid_00_insertOpts]
 * maxrange = 20                // see voxel::TVoxelInsertionOptions
 * [map_freeSpaceGrid_00_conversionOpts]
 * robot = ground               // see freespace::TConversionOptions
 * [map_freeSpaceGrid_00_likelihoodOpts]
 * likelihoodMethod = lmLikelihoodField_Thrun   // see COccupancyGridMap2D::TLikelihoodOptions
 * [map_freeSpaceGrid_00_renderOpts]
 * showCeiling = true           // see freespace::TLayerSceneOptions
 * \endcode
 */
class CFreeSpaceGridMap2D : public mrpt::maps::COccupancyGridMap2D
{
  DEFINE_SERIALIZABLE(CFreeSpaceGridMap2D, mrpt_mapconv)

 public:
  /** An empty map. \param resolution size of voxels and cells, 0.0001 to 1000 m
   * \exception std::invalid_argument for another resolution */
  explicit CFreeSpaceGridMap2D(double resolution = voxel::VoxelMapParams().resolution);
  ~CFreeSpaceGridMap2D() override;
  CFreeSpaceGridMap2D(const CFreeSpaceGridMap2D& o);
  CFreeSpaceGridMap2D& operator=(const CFreeSpaceGridMap2D& o);

  /** How scans go into the voxel map. Takes effect with the next insertion. */
  voxel::TVoxelInsertionOptions voxelInsertionOptions;
  /** What getVisualizationInto() shows beside the occupancy grid. */
  freespace::TLayerSceneOptions renderingOptions;

  const freespace::TConversionOptions& conversionOptions() const { return m_conversion; }
  /** Sets the conversion's options and converts anew.
   * \exception std::invalid_argument for bad ones; the map then stays as it was */
  void setConversionOptions(const freespace::TConversionOptions& options);

  /** The voxel map. */
  const octomap::OcTree& octree() const { return *m_octree; }
  /** All layers, on a frame that holds every known voxel and maybe some room around. */
  const freespace::Layers& layers() const { return m_layers.layers(); }
  /** All layers on the exact bounding box of the known voxels; empty if there is none. */
  freespace::Layers exactLayers() const;

  /** Replaces the voxel map, and the resolution with it, and converts it. The tree's sensor model
   * (probHit, occupancyThres, …) becomes that of voxelInsertionOptions.
   * \exception std::exception if it cannot be converted; the map then stays as it was */
  void setVoxelMap(const octomap::OcTree& tree);
  void setVoxelMap(const mrpt::maps::COctoMap& map);
  void setVoxelMap(std::unique_ptr<octomap::OcTree> tree);
  /** Replaces the voxel map by an OctoMap file's (`.bt`, `.ot`). Such a file holds no sensor model:
   * that of voxelInsertionOptions stays and goes for the tree.
   * \exception std::runtime_error naming the file and what is wrong with it */
  void loadVoxelMap(const std::string& file);

  /** Writes all cells of the grid anew, should someone have changed them through the base class. */
  void refreshGrid() { showAllCells(); }

  /** What each insertion into this object took, with the whole history; see saveToCSVFile(). Times
   * [s]: "insert", and its parts "insert.voxels" and "insert.layers"; user measures:
   * "insert.columns", how many columns have changed, and "insert.laidOut", 1 if all layers had to
   * be laid out anew for it, else 0. A copy begins with none, and so does a map that another one
   * was assigned to or that was read from a stream. rbpf-slam copies its particles' maps whenever
   * it resamples: there the saved file begins at the last copy. */
  const mrpt::system::CTimeLogger& insertionTimes() const;

  void determineMatching2D(const mrpt::maps::CMetricMap* otherMap,
                           const mrpt::poses::CPose2D& otherMapPose,
                           mrpt::tfest::TMatchingPairList& correspondences,
                           const mrpt::maps::TMatchingParams& params,
                           mrpt::maps::TMatchingExtraResults& extraResults) const override;
  void auxParticleFilterCleanUp() override { restoreGrid(); }
  void getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const override;
  /** Saves the grid as the base class does, all layers as PREFIX_layers.tif and PREFIX_<layer>.png,
   * the voxel map as PREFIX.ot, and insertionTimes(), if there are any, as PREFIX_times.csv; each
   * file appears whole or not at all.
   * \exception std::runtime_error naming the file and the reason if one cannot be written */
  void saveMetricMapRepresentationToFile(const std::string& prefix) const override;
  std::string asString() const override;

 protected:
  void internal_clear() override;
  bool internal_insertObservation(
      const mrpt::obs::CObservation& obs,
      const std::optional<const mrpt::poses::CPose3D>& robotPose = std::nullopt) override;

 private:
  const grid::Layer<float>& occupancy() const;
  bool gridFitsLayers() const;
  void restoreGrid() const;
  static const CFreeSpaceGridMap2D& withRestoredGrid(const CFreeSpaceGridMap2D& map);
  mrpt::system::CTimeLogger& times() const;
  void forgetTimes();
  void showAllCells();
  void showCells(const voxel::ColumnSet& columns);
  void takeOctree(std::unique_ptr<octomap::OcTree> tree);
  bool followOctree();
  void warnIfNothingIsFree();
  void writeBaseOptions(mrpt::serialization::CArchive& out) const;
  void readBaseOptions(mrpt::serialization::CArchive& in);
  void readOctree(mrpt::serialization::CArchive& in);

  mrpt::system::COutputLogger m_log;
  observation::SayOnceLog m_warnings;
  freespace::TConversionOptions m_conversion;
  std::unique_ptr<octomap::OcTree> m_octree;
  freespace::IncrementalLayers m_layers;
  voxel::ColumnSet m_pending;  //!< changed in the octree, but not yet in the layers
  bool m_sawFree = false;      //!< some cell was free once, so nobody needs to be warned
  mutable std::mutex m_lazy;   //!< for what const methods change: the grid's layout and m_times
  /** Made when it is needed: it has 0.6 MB, and most copies of a map never insert anything. */
  mutable std::unique_ptr<mrpt::system::CTimeLogger> m_times;

  MAP_DEFINITION_START(CFreeSpaceGridMap2D)
  mrpt_mapconv::voxel::VoxelMapParams creationOpts;
  mrpt_mapconv::voxel::TVoxelInsertionOptions insertionOpts;
  mrpt_mapconv::freespace::TConversionOptions conversionOpts;
  mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions likelihoodOpts;
  mrpt_mapconv::freespace::TLayerSceneOptions renderOpts;
  MAP_DEFINITION_END(CFreeSpaceGridMap2D)
};

}  // namespace mrpt_mapconv
