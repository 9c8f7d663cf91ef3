#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt_mapconv/scan/CellBits.h>
#include <mrpt_mapconv/scan/ProfileParams.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mrpt_mapconv::scan
{
/** Where a scan was taken. */
struct Viewpoint
{
  mrpt::poses::CPose3D sensorPose;  //!< sensor -> map, whose z axis points up
  double baseZ = 0;                 //!< height of the robot's base in the map [m]
  double azimuthStep = 0;           //!< between the sensor's columns [rad]; 0: not known
};

/** A scan that says nothing reliable: its pose is not finite, or the sensor is lower than all
 * slices. */
class UnusableScan : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** What was found in a scan. */
struct ProfileStatistics
{
  std::size_t points = 0, objectPoints = 0, structurePoints = 0;
  std::int32_t lines = 0;          //!< azimuths that were looked along
  std::int32_t linesWithWall = 0;  //!< those with a structural element; 0 without the filter
  std::size_t occupiedCells = 0, freeCells = 0;
  /** Height above the robot's base [m] of a ceiling that the structure slice holds, which then
   * passes for walls: see ScanProfile. */
  std::optional<double> ceiling;

  /** linesWithWall / lines; 0 without lines. */
  double shareWithWall() const
  {
    return lines > 0 ? static_cast<double>(linesWithWall) / lines : 0.0;
  }
};

/** The 3D inverse sensor model of Mora et al. 2024, sections III-B to III-D: which 2D cells one
 * scan says are occupied, and which are free.
 *
 * - Object cells O hold a point of the object slice at a horizontal range in [minRange, maxRange];
 *   wall cells W hold a point of the structure slice, at any range.
 * - `sectors` lines leave the sensor at even azimuths, the first along +x, each through 4-connected
 *   cells. Where a line meets a corner exactly it first goes on along the axis that it is more
 *   along, at 45° along the one clockwise of it. By default there are as few lines as are divisible
 *   by 4 and at most one cell apart at maxRange.
 * - The wall of a line is the nearest W-cell, by the distance of its centre from the sensor, that
 *   the line crosses or that holds a structure point whose azimuth is within structureGap of the
 *   line's. A line without one is not cut; neither is any without the reflection filter. The cell
 *   that the sensor is in lies on all lines: under a lintel a scan says next to nothing.
 * - On a line an O-cell is valid if its centre is at most structureTolerance farther away than that
 *   of the wall.
 * - Whole shape: valid O-cells are occupied. Cells that are not in O, come before the line's last
 *   valid O-cell and have their centre nearer than the wall's are free. An O-cell that no line
 *   crosses is judged by the wall of a line of its own, through its centre.
 * - Closest point: the first valid O-cell of each line is occupied; cells before it whose centre is
 *   nearer than the wall's are free.
 * - A cell is occupied if any line says so, else free if any line says so.
 *
 * A **ceiling in the structure slice** (only looked for with the reflection filter) changes none of
 * this, but is reported. Around the sensor lie 256 sectors, 64 a quadrant, even along |x| + |y| =
 * 1; "near" is within 5 cm of height, or a sixth of the slice if that is less. Through the
 * structure points that are each their sector's nearest, weighted by 1/(1 + range²) in metres, goes
 * a plane of least squares, with slopes of at most 0.1 (LevelPlaneFit says how it is kept level);
 * five times it is fitted again without the points that are below it and not near. Those near the
 * last one are level; the ceiling's height is the mean of the plane's at them. It is one if
 * - at least 16 sectors have structure points, and in at least a third of them the nearest is
 * level;
 * - it is no wall, by either of two signs. It goes on: at least three fifths are level, in most of
 *   these the sector's points near the plane have ranges that differ by more than 0.5 m, and fewer
 *   points of the slice lie higher than a quarter of the number near it. Or it ends the slice: its
 *   height is more than twice "near" below structureMaxZ, and hardly any points lie higher, at most
 *   a hundredth;
 * - it does harm: at least a tenth of the O-cells have their centre more than 0.3 m behind the
 *   nearest structure point of their sector.
 *
 * Time grows with the number of points, of lines and of cells on the way to the farthest object on
 * each; memory with the square of the distance to the farthest object of all: ten rasters of that
 * many bits, 50 MB each at 10 000 cells.
 *
 * The object keeps its working memory, so a series of scans is best put through the same one. It is
 * for one thread at a time. */
class ScanProfile
{
 public:
  ScanProfile();
  ~ScanProfile();
  ScanProfile(ScanProfile&&) noexcept;
  ScanProfile& operator=(ScanProfile&&) noexcept;

  /** Finds the cells of one scan; those of the one before are forgotten.
   * \param points in the sensor's frame [m]; ones that are not finite are left out, and (0, 0, 0)
   * \param resolution of the cells [m]; cell (kx, ky) covers [kx·resolution, (kx+1)·resolution) …
   * \exception std::invalid_argument for bad parameters or a bad resolution
   * \exception UnusableScan see there; also for a sensor more than 10^9 cells from the origin */
  void compute(const std::vector<mrpt::math::TPoint3Df>& points, const Viewpoint& view,
               double resolution, const ProfileParams& params);

  /** Both on the same frame, which is a square around the sensor; no cell is in both. */
  const CellBits& occupied() const;
  const CellBits& free() const;
  /** The smallest frame that holds all of their cells; empty if there are none. */
  grid::GridFrame bounds() const;
  const ProfileStatistics& statistics() const;

 private:
  struct Workspace;
  std::unique_ptr<Workspace> m_work;
};

}  // namespace mrpt_mapconv::scan
