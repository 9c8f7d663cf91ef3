#pragma once

#include <mrpt_mapconv/scan/ProfileParams.h>

#include <cstdint>
#include <vector>

#include "LineFan.h"
#include "Rasters.h"
#include "SensorPlace.h"

namespace mrpt_mapconv::scan
{
/** Walks lines from the sensor through 4-connected cells, and marks what they say.
 *
 * A line that goes along its major axis fast crosses a run of cells in each row of the minor one.
 * Cells are therefore looked at, and filled, by whole words of bits. */
class LineWalk
{
 public:
  /** The sensor's cell is the middle one of the rasters.
   * \param tolerance how much farther than its wall a line's O-cells are valid [cells] */
  LineWalk(const SensorPlace& place, Model model, double tolerance, Rasters& rows, Rasters& columns,
           std::vector<std::int32_t>& scratch);

  /** Marks the cells that a line says are occupied or free.
   * \param reach of anything on the line [cells]
   * \param wallSq square of the distance of its wall [cells²], infinite without one; lowered to
   * that of the nearest W-cell that it crosses */
  void walk(const Line& line, double reach, double& wallSq);
  /** True if a line crosses a cell, counted from the sensor's. */
  bool crosses(const Line& line, std::int32_t ix, std::int32_t iy) const;
  /** Square of the distance to the nearest W-cell that a line crosses [cells²], among those that
   * are not farther than `reach` [cells]; infinite without one. */
  double crossedWallSq(const Line& line, double reach) const;
  /** True if an O-cell at this distance is valid on a line with this wall. */
  bool isValid(double distanceSq, double wallSq) const
  {
    const double limit = validUpTo(wallSq);
    return distanceSq <= limit * limit;
  }

 private:
  class Path;
  struct Findings;

  double validUpTo(double wallSq) const;
  bool look(const Path& path, std::int32_t minor, std::int32_t first, std::int32_t last,
            Findings& found);
  void fillFree(const Path& path, const Findings& found);

  const SensorPlace& m_place;
  const Model m_model;
  const double m_tolerance;
  Rasters &m_rows, &m_columns;
  std::vector<std::int32_t>& m_ends;  //!< last cell of each row's run
};

}  // namespace mrpt_mapconv::scan
