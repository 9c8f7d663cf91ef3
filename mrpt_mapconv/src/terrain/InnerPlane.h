#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <optional>
#include <vector>

#include "Tile.h"

namespace mrpt_mapconv::terrain
{
/** Where the cells of a plane lie that are not at its border: noise draws those at the border of a
 * tread towards what lies below or above it, and the tread's plane with them. */
class InnerPlane
{
 public:
  /** \param all the plane \param cells of it, at least one
   * \param minCells if fewer lie inside, all count */
  InnerPlane(const TerrainPlane& all, const std::vector<CellRef>& cells, std::int64_t minCells,
             double resolution);

  double heightAt(double x, double y) const;  //!< [m]

 private:
  const TerrainPlane& m_all;
  double m_resolution;
  std::optional<Plane> m_inner;
};

}  // namespace mrpt_mapconv::terrain
