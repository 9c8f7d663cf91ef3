#pragma once

#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <vector>

#include "Disc.h"

namespace mrpt_mapconv::path
{
/** Between which heights of its centre a sphere is clear of all floors and ceilings. */
struct SphereLimits
{
  double low, high;      //!< [m]
  bool allCellsHaveRun;  //!< false: some cell in reach has no floor or lies off the map
};

/** The nearest cell that stops a sphere at any height. */
struct Obstacle
{
  Infeasibility kind = Infeasibility::None;
  mrpt::math::TPoint2D centre;  //!< [m]
};

/** Fits spheres between the floors and ceilings of the layers. */
class SphereFit
{
 public:
  SphereFit(const freespace::Layers& layers, const Disc& disc);
  /** Limits where the disc is now; cells without a floor are left out. */
  SphereLimits limits();
  /** How far the sphere reaches up and down from its centre over a cell of the frame, where the
   * disc was when limits() was called last [m]. */
  double halfHeight(const Disc::Row& row, std::int32_t kx) const { return m_half[at(row, kx)]; }
  /** What stops the sphere where the disc is now: the nearest wall; without one, the nearest
   * unknown cell. */
  Obstacle obstacle(bool unknownIsPassable) const;

 private:
  void addRow(const Disc::Row& row);
  std::size_t at(const Disc::Row& row, std::int32_t kx) const
  {
    return row.index * m_disc.side() + static_cast<std::size_t>(kx - m_disc.kxFirst());
  }

  const freespace::Layers& m_layers;
  const Disc& m_disc;
  bool m_leavesFrame = false;
  // per column of the disc, so that rows are added without a dependency between their cells
  std::vector<double> m_low, m_high, m_sum;
  std::vector<double> m_half;  // per cell of the disc
};

}  // namespace mrpt_mapconv::path
