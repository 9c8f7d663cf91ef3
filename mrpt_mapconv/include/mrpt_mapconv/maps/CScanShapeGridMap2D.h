#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/maps/MapLog.h>
#include <mrpt_mapconv/maps/SelfDescription.h>
#include <mrpt_mapconv/scan/ScanGridParams.h>
#include <mrpt_mapconv/scan/ScanInsertionOptions.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <memory>
#include <optional>
#include <string>

namespace mrpt::obs
{
class CObservation2DRangeScan;
}

namespace mrpt_mapconv
{
/** An occupancy grid that 3D scans are inserted into with the whole shape of the objects they show,
 * and without what is seen through or in glass (Mora et al., IEEE Sensors J. 2024); see
 * scan::ScanProfile. Its cells are those of any COccupancyGridMap2D, so MRPT's likelihoods, ICP,
 * planners and viewers use it as such. Cells lie on integer keys (grid::GridFrame), and the grid
 * grows as needed, by some more than that. Whoever changes its size or contents through the base
 * class is followed: what is there is what the next scan is inserted into.
 *
 * Observations: see observation::sensorPoints(); 2D scans are inserted as COccupancyGridMap2D does,
 * with its own insertionOptions, but rays that are not finite, or negative, count as invalid.
 * Others are ignored. A scan that says nothing, or nothing reliable (no point or valid ray, no
 * object, a pose that is not finite, a ceiling for walls, see also scan::UnusableScan), is skipped
 * with a warning, once for each reason and sensor; see lastSkip(). Bad options and a grid that
 * would become too large, or lie too far away, are exceptions of insertObservation(). All of these
 * leave the map exactly as it was. So do likelihoods: lmMeanInformation, for which MRPT's grid
 * inserts the scan and counts none of its rays, is as little of use here, but inserts nothing.
 *
 * In an ini file, with any prefix that MRPT gives:
 * \code
 * [map]
 * scanShapeGrid_count = 1
 * [map_scanShapeGrid_00_creationOpts]
 * resolution = 0.05            // [m] size of a cell
 * maxGridCells = 4e8           // a scan that would make the grid larger is refused
 * [map_scanShapeGrid_00_insertOpts]
 * structureMinZ = 2.3          // see scan::TScanInsertionOptions; and for 2D scans
 * structureMaxZ = 2.6          // COccupancyGridMap2D::TInsertionOptions
 * [map_scanShapeGrid_00_likelihoodOpts]
 * likelihoodMethod = lmLikelihoodField_Thrun   // see COccupancyGridMap2D::TLikelihoodOptions
 * \endcode
 */
class CScanShapeGridMap2D : public mrpt::maps::COccupancyGridMap2D, public maps::SelfDescribing
{
  DEFINE_SERIALIZABLE(CScanShapeGridMap2D, mrpt_mapconv)

 public:
  /** An empty map. \param resolution size of a cell, 0.0001 to 1000 m
   * \exception std::invalid_argument for another resolution */
  explicit CScanShapeGridMap2D(double resolution = scan::ScanGridParams().resolution);
  ~CScanShapeGridMap2D() override;
  /** Copies are made per particle: what is needed only during an insertion is not copied, and what
   * one of them has said once, the others do not repeat (MRPT copies a CMultiMetricMap by way of a
   * stream, which does not hold that). A copy has a logger of its own, without the callbacks and
   * levels of the other's; a map that is assigned to keeps its logger. */
  CScanShapeGridMap2D(const CScanShapeGridMap2D& o);
  CScanShapeGridMap2D& operator=(const CScanShapeGridMap2D& o);

  /** How 3D scans are inserted. Takes effect with the next insertion. */
  scan::TScanInsertionOptions scanInsertionOptions;
  /** A scan that would make the grid larger than this is refused by an exception. MRPT itself
   * counts up to 2^32 − 1. */
  double maxGridCells = scan::ScanGridParams().maxGridCells;

  /** What was found in the last 3D scan that was inserted into this object, or skipped for having
   * no valid object; nothing if there was none. */
  scan::ProfileStatistics lastScan() const { return m_lastScan; }
  /** Why the last observation changed nothing, in one line; empty if it was inserted. */
  std::string lastSkip() const { return m_log.lastSkip(); }
  /** The kind of that reason, without the figures of the scan; kCeilingSkip if the structure slice
   * holds the ceiling, empty for an observation that is not for this map. */
  std::string lastSkipKind() const { return m_log.lastSkipKind(); }
  static constexpr const char* kCeilingSkip = "ceiling";
  /** Where the grid lies. */
  grid::GridFrame frame() const;
  /** Probability of occupancy of each cell, NaN where it is unknown (exactly 0.5). */
  grid::Layer<float> probability() const;
  /** The same as the library's occupancy layers: 0 where p < 0.5, p where above, −1 unknown. */
  grid::Layer<float> occupancy() const;

  void getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const override;
  void saveMetricMapRepresentationToFile(const std::string& prefix) const override;
  std::string asString() const override;
  /** How 3D scans are seen: scanInsertionOptions.profile. */
  maps::SelfDescription describe() const override;

  /** Where warnings go, what was found in the first 3D scan (not in that of a map that was read
   * from a stream with something in it) and, at level DEBUG, in each. */
  mrpt::system::COutputLogger& log() { return m_log.logger; }

 protected:
  void internal_clear() override;
  bool internal_insertObservation(
      const mrpt::obs::CObservation& obs,
      const std::optional<const mrpt::poses::CPose3D>& robotPose = std::nullopt) override;

 private:
  struct Workspace;

  Workspace& workspace();
  bool insert3D(const mrpt::obs::CObservation& obs, const mrpt::poses::CPose3D& robotPose);
  bool insert2D(const mrpt::obs::CObservation2DRangeScan& scan,
                const mrpt::poses::CPose3D& robotPose);
  void checkNear(const mrpt::poses::CPose3D& sensorPose) const;
  void warnOfOverlap();
  bool hasReported();
  void report(const mrpt::obs::CObservation& obs);
  void startEmpty();
  bool isAsStarted() const;
  void makeRoomFor(const grid::GridFrame& needed);
  void checkSize(const grid::GridFrame& frame) const;
  void layOut(const grid::GridFrame& frame);

  maps::MapLog m_log;
  double m_cellSize;  //!< the resolution, which the base class rounds to a float [m]
  scan::ProfileStatistics m_lastScan;
  std::unique_ptr<Workspace> m_work;  //!< made for the first 3D scan

  MAP_DEFINITION_START(CScanShapeGridMap2D)
  mrpt_mapconv::scan::ScanGridParams creationOpts;
  mrpt_mapconv::scan::TScanInsertionOptions scanInsertionOpts;
  mrpt::maps::COccupancyGridMap2D::TInsertionOptions insertionOpts;
  mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions likelihoodOpts;
  mrpt_mapconv::observation::SayOnceLog said;  //!< by all maps made of it, e.g. one per particle
  MAP_DEFINITION_END(CScanShapeGridMap2D)
};

}  // namespace mrpt_mapconv
