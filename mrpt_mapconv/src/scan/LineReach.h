#pragma once

#include <vector>

#include "LineFan.h"
#include "SensorPlace.h"

namespace mrpt_mapconv::scan
{
/** How far away lines meet anything: for narrow sectors a bound on the distances of the cells that
 * a line in them can cross. A walk along a line can end there. */
class LineReach
{
 public:
  void clear();
  /** Adds a cell, counted from the sensor's. */
  void add(const SensorPlace& place, std::int32_t ix, std::int32_t iy);
  /** No cell that the line crosses has its centre farther away [cells]; negative: there is none. */
  double of(const Line& line) const;

 private:
  static constexpr int kSectors = 1024;

  double m_near = -1;           //!< of cells so near that they can lie in any direction
  std::vector<double> m_bound;  //!< for each sector
};

}  // namespace mrpt_mapconv::scan
