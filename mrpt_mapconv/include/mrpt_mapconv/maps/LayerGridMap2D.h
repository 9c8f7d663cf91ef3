#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/StyledLayer.h>
#include <mrpt_mapconv/maps/InsertionTimes.h>
#include <mrpt_mapconv/maps/MapLog.h>
#include <mrpt_mapconv/maps/SelfDescription.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>

#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::maps
{
/** The base of map classes whose grid shows a layer that they make in their own way.
 *
 * A class lists its options, names its layers and inserts a scan into them; what MRPT and its
 * programs want of a map is here. A raw cell of the grid is +127 for free, 0 for unknown,
 * −max(1, round(127·value)) for occupied, see grid::rawGridCell().
 *
 * Observations are the scans that observation::sensorPoints() reads. Nothing is inserted where a
 * likelihood asks (updateInfoChangeOnly.enabled). What is not inserted is named by lastSkip(), and,
 * if it is a scan, on the log, once for each reason and sensor.
 *
 * MRPT's particle filter resizes the grid behind the map's back (resizeGrid() is not virtual, and
 * keeps what the cells say). Methods that may change the map lay it out anew: the next insertion
 * and auxParticleFilterCleanUp(), which ends a step of the filter. Const ones, that is matching,
 * saving and copying, work on a grid that is as it should be. MRPT's likelihood cannot be hooked
 * (it is private in its class): a grid that setSize() has erased is used as it is for likelihoods
 * until then. While nothing is known the grid is left alone; it may hold what the filter has
 * averaged into it.
 */
class LayerGridMap2D : public mrpt::maps::COccupancyGridMap2D, public SelfDescribing
{
 public:
  /** All layers in the order of export, on one frame; valid until the map changes. */
  virtual std::vector<grid::StyledLayer> styledLayers() const = 0;

  /** The layers, with titles and units. */
  SelfDescription describe() const override;

  /** The size of a cell [m], which the grid itself rounds to a float. */
  double cellSize() const { return m_cellSize; }
  /** Why the last observation changed nothing, in one line; empty if it was inserted. */
  std::string lastSkip() const { return m_log.lastSkip(); }
  /** Where warnings go. */
  mrpt::system::COutputLogger& log() { return m_log.logger; }
  /** How long each insertion into this object took, with the whole history; see saveToCSVFile().
   * "insert" [s] is measured here, the class may add more. A copy begins with none, and so does a
   * map that another one was assigned to or that was read from a stream. */
  const mrpt::system::CTimeLogger& insertionTimes() const { return m_times.logger(); }

  void determineMatching2D(const mrpt::maps::CMetricMap* otherMap,
                           const mrpt::poses::CPose2D& otherMapPose,
                           mrpt::tfest::TMatchingPairList& correspondences,
                           const mrpt::maps::TMatchingParams& params,
                           mrpt::maps::TMatchingExtraResults& extraResults) const override;
  void auxParticleFilterCleanUp() override;
  void getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const override;
  /** Saves the grid as the base class does, what saveLayers() stages, and insertionTimes(), if
   * there are any, as PREFIX_times.csv; each file appears whole or not at all.
   * \exception std::runtime_error naming the file and the reason if one cannot be written */
  void saveMetricMapRepresentationToFile(const std::string& prefix) const override;

 protected:
  /** An empty map. \exception std::invalid_argument unless the resolution is 0.0001 to 1000 m */
  LayerGridMap2D(const std::string& ownName, double resolution);
  /** A copy of what is here; its grid shows o's layer, and so the copy's. */
  LayerGridMap2D(const LayerGridMap2D& o);
  LayerGridMap2D& operator=(const LayerGridMap2D& o);

  // --- what a class does in its own way
  /** The layer that the grid shows: occupancy, or an empty frame while nothing is known. */
  virtual const grid::Layer<float>& shownLayer() const = 0;
  /** Called before an insertion. \exception std::invalid_argument for options that are not valid */
  virtual void checkOptions() const = 0;
  /** Whether 2D scans are inserted, too. */
  virtual bool inserts2D() const { return false; }
  /** Inserts a scan, of at least one point, into the layers, and has the grid show them.
   * \return why it changed nothing; empty if it was inserted
   * \exception std::exception if it cannot be inserted; the map then stays as it was */
  virtual std::string insertScan(const observation::SensorPoints& scan) = 0;
  /** Stages files beside the grid's: here all layers as NAME_layers.tif and NAME_<layer>.png, if
   * anything is known. */
  virtual void saveLayers(files::OutputDir& out, const std::string& name) const;
  /** Adds a map in which something is known to a 3D scene: here the shown layer and, above it, all
   * heights. */
  virtual void drawLayers(mrpt::opengl::CSetOfObjects& scene) const;

  // --- what it uses for that
  /** Writes the grid anew, of the size of the shown layer; a small unknown one if that is empty. */
  void showAllCells();
  /** The same for those cells only, unless the grid is not as large as the shown layer.
   * \return true if it was laid out anew */
  bool showCells(const voxel::ColumnSet& columns);
  /** \exception std::invalid_argument as the constructor */
  void setCellSize(double resolution);
  observation::SayOnceLog& warnings() { return m_log.warnings; }
  mrpt::system::CTimeLogger& times() { return m_times.logger(); }
  void forgetTimes() { m_times.forget(); }

  bool internal_insertObservation(
      const mrpt::obs::CObservation& obs,
      const std::optional<const mrpt::poses::CPose3D>& robotPose = std::nullopt) override;

 private:
  void startEmpty();
  void showAllCellsOf(const grid::Layer<float>& layer);
  bool isLaidOut() const;
  bool mustBeLaidOut() const;
  template <class Use>
  void withRightGrid(const Use& use) const;

  MapLog m_log;
  InsertionTimes m_times;
  double m_cellSize;
};

}  // namespace mrpt_mapconv::maps
