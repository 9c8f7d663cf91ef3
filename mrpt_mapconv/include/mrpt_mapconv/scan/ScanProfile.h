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
   * passes for walls on all sides: of 64 sectors around the sensor (16 a quadrant, even along
   * |x| + |y| = 1) that hold objects, at least 8, more than half have their nearest structure point
   * within 5 cm (a quarter of the slice, if that is less) of the median height of all sectors'
   * nearest ones, and an object more than 0.3 m behind it. */
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
