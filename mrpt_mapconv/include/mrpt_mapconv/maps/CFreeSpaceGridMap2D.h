#pragma once

#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/ConversionOptions.h>
#include <mrpt_mapconv/freespace/FreeSpaceScene.h>
#include <mrpt_mapconv/maps/LayerGridMap2D.h>
#include <mrpt_mapconv/voxel/VoxelMap.h>
#include <mrpt_mapconv/voxel/VoxelMapParams.h>

#include <memory>
#include <string>
#include <vector>

namespace mrpt::maps
{
class COctoMap;
}

namespace mrpt_mapconv
{
/** An occupancy grid that is made of a voxel map by free-space projection.
 *
 * insertObservation() inserts a scan into the voxel map and converts the columns that have changed;
 * the grid that this map *is* always shows the layer for the configured robot, so MRPT's
 * likelihoods, ICP, planners and viewers use it as any other COccupancyGridMap2D. Its frame is that
 * of layers(), whose cells lie on voxel columns. What its cells say, which observations count, and
 * what happens when MRPT resizes it: see maps::LayerGridMap2D. 2D scans count unless insert2D is
 * false.
 *
 * insertionTimes() has, beside "insert", its parts "insert.voxels" and "insert.layers" [s], and as
 * user measures "insert.columns", how many columns have changed, and "insert.laidOut", 1 if all
 * layers had to be laid out anew for it, else 0. rbpf-slam copies its particles' maps whenever it
 * resamples: there the saved file begins at the last copy. Beside the layers, on the exact bounding
 * box of the known voxels, the voxel map is saved as PREFIX.ot.
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
class CFreeSpaceGridMap2D : public maps::LayerGridMap2D
{
  DEFINE_SERIALIZABLE(CFreeSpaceGridMap2D, mrpt_mapconv)

 public:
  /** An empty map. \param resolution size of voxels and cells, 0.0001 to 1000 m
   * \exception std::invalid_argument for another resolution */
  explicit CFreeSpaceGridMap2D(double resolution = voxel::VoxelMapParams().resolution);
  CFreeSpaceGridMap2D(const CFreeSpaceGridMap2D& o) = default;
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
  const voxel::VoxelMap& voxelMap() const { return m_voxels; }
  /** The voxel map as an octree, made when it is first asked for and kept until the map changes,
   * with which the reference ends; several threads may ask at once. */
  const octomap::OcTree& octree() const { return m_voxels.octree(); }
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

  std::vector<grid::StyledLayer> styledLayers() const override { return layers().styled(); }
  std::string asString() const override;

 protected:
  void internal_clear() override;
  const grid::Layer<float>& shownLayer() const override { return shownOf(layers()); }
  void checkOptions() const override { voxelInsertionOptions.check(); }
  bool inserts2D() const override { return voxelInsertionOptions.insert2D; }
  std::string insertScan(const observation::SensorPoints& scan) override;
  void saveLayers(files::OutputDir& out, const std::string& name) const override;
  void drawLayers(mrpt::opengl::CSetOfObjects& scene) const override;

 private:
  const grid::Layer<float>& shownOf(const freespace::Layers& layers) const;
  void takeVoxels(voxel::VoxelMap voxels);
  bool followVoxels();
  void warnIfNothingIsFree();
  void readVoxels(mrpt::serialization::CArchive& in);

  freespace::TConversionOptions m_conversion;
  voxel::VoxelMap m_voxels;
  freespace::IncrementalLayers m_layers;
  voxel::ColumnSet m_pending;  //!< changed in the voxel map, but not yet in the layers
  bool m_sawFree = false;      //!< some cell was free once, so nobody needs to be warned

  MAP_DEFINITION_START(CFreeSpaceGridMap2D)
  mrpt_mapconv::voxel::VoxelMapParams creationOpts;
  mrpt_mapconv::voxel::TVoxelInsertionOptions voxelInsertionOpts;
  mrpt_mapconv::freespace::TConversionOptions conversionOpts;
  mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions likelihoodOpts;
  mrpt_mapconv::freespace::TLayerSceneOptions renderOpts;
  mrpt_mapconv::observation::SayOnceLog said;  //!< by all maps made of it, e.g. one per particle
  MAP_DEFINITION_END(CFreeSpaceGridMap2D)
};

}  // namespace mrpt_mapconv
