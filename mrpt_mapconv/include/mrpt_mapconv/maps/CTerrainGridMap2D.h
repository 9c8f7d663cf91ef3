#pragma once

#include <mrpt/maps/CHeightGridMap2D_Base.h>
#include <mrpt_mapconv/maps/LayerGridMap2D.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>
#include <mrpt_mapconv/terrain/TerrainOptions.h>

#include <string>
#include <vector>

namespace mrpt_mapconv
{
/** A terrain map for legged robots: cells with fused heights, planes, and leaves, squares of cells
 * that are stored as one (Zhou et al. 2023); see terrain::TerrainMap.
 *
 * The grid that this map *is* shows where the terrain is traversable, so MRPT's likelihoods, ICP,
 * planners and viewers use it as any other COccupancyGridMap2D; as a CHeightGridMap2D_Base it gives
 * heights, those of planes where there are. Its cells are centred on multiples of the resolution.
 * After each scan all of it is up to date. Only 3D scans count; how sure the robot is of its pose
 * is taken from the insertion options, since MRPT hands a map the plain pose. What its cells say,
 * which observations count, and what happens when MRPT resizes it: see maps::LayerGridMap2D.
 *
 * insertionTimes() has, beside "insert", its parts "insert.cells", "insert.planes" and
 * "insert.layers" [s]. Beside the layers PREFIX_leaves.png, PREFIX_planes.csv and PREFIX_steps.csv
 * are saved, see terrain::exportTerrain().
 *
 * In an ini file, with any prefix that MRPT gives:
 * \code
 * [map]
 * terrainGrid_count = 1
 * [map_terrainGrid_00_creationOpts]
 * resolution = 0.05            // [m] size of a cell
 * maxGridCells = 1e8           // a scan that would need larger layers is refused
 * [map_terrainGrid_00_insertOpts]
 * maxHeight = 2                // see terrain::TTerrainInsertionOptions
 * [map_terrainGrid_00_terrainOpts]
 * planeTolerance = 0.03        // see terrain::TTerrainOptions
 * [map_terrainGrid_00_likelihoodOpts]
 * likelihoodMethod = lmLikelihoodField_Thrun   // see COccupancyGridMap2D::TLikelihoodOptions
 * [map_terrainGrid_00_renderOpts]
 * showOutlines = true          // see terrain::TTerrainSceneOptions
 * \endcode
 */
class CTerrainGridMap2D : public maps::LayerGridMap2D, public mrpt::maps::CHeightGridMap2D_Base
{
  DEFINE_SERIALIZABLE(CTerrainGridMap2D, mrpt_mapconv)

 public:
  /** An empty map. \param resolution size of a cell, 0.0001 to 1000 m
   * \exception std::invalid_argument for another resolution, or options that are not valid */
  explicit CTerrainGridMap2D(double resolution = terrain::TerrainGridParams().resolution,
                             const terrain::TTerrainOptions& options = {});

  /** How scans go into the cells. Takes effect with the next insertion. */
  terrain::TTerrainInsertionOptions terrainInsertionOptions;
  /** What getVisualizationInto() shows; without leaves it is the occupancy grid. */
  terrain::TTerrainSceneOptions renderingOptions;
  /** A scan that would need layers of more cells is refused by an exception. */
  double maxGridCells = terrain::TerrainGridParams().maxGridCells;

  /** Cells, planes, leaves and steps. */
  const terrain::TerrainMap& terrain() const { return m_terrain; }
  /** All layers; of its traversability the grid is made. */
  const terrain::TerrainLayers& layers() const { return m_layers; }

  std::vector<grid::StyledLayer> styledLayers() const override;
  maps::SelfDescription describe() const override;
  std::string asString() const override;

  // --- CHeightGridMap2D_Base, by the cells of the layers' frame
  /** Adds a point, of pt_z_std or, if that is 0, of the insertion options' rangeSigma.
   * \return false, and nothing changed, if it is not finite or too far away */
  bool insertIndividualPoint(double x, double y, double z,
                             const TPointInsertParams& params = TPointInsertParams()) override;
  double dem_get_resolution() const override { return cellSize(); }
  std::size_t dem_get_size_x() const override;
  std::size_t dem_get_size_y() const override;
  bool dem_get_z_by_cell(std::size_t cx, std::size_t cy, double& z_out) const override;
  bool dem_get_z(double x, double y, double& z_out) const override;
  /** Has planes, leaves, layers and grid follow the points. */
  void dem_update_map() override;

 protected:
  void internal_clear() override;
  const grid::Layer<float>& shownLayer() const override { return m_layers.traversability; }
  void checkOptions() const override { terrainInsertionOptions.check(); }
  std::string insertScan(const observation::SensorPoints& scan) override;
  void saveLayers(files::OutputDir& out, const std::string& name) const override;
  void drawLayers(mrpt::opengl::CSetOfObjects& scene) const override;

 private:
  void checkRoomFor(const grid::GridFrame& needed, bool forgets) const;
  void showTerrain();

  terrain::TerrainMap m_terrain;
  terrain::TerrainLayers m_layers;

  MAP_DEFINITION_START(CTerrainGridMap2D)
  mrpt_mapconv::terrain::TerrainGridParams creationOpts;
  mrpt_mapconv::terrain::TTerrainInsertionOptions terrainInsertionOpts;
  mrpt_mapconv::terrain::TTerrainOptions terrainOpts;
  mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions likelihoodOpts;
  mrpt_mapconv::terrain::TTerrainSceneOptions renderOpts;
  mrpt_mapconv::observation::SayOnceLog said;  //!< by all maps made of it, e.g. one per particle
  MAP_DEFINITION_END(CTerrainGridMap2D)
};

}  // namespace mrpt_mapconv
