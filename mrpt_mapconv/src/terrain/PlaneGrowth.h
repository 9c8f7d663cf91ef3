#pragma once

#include <vector>

#include "Flood.h"
#include "PlaneSet.h"
#include "SeedPlane.h"
#include "TileMap.h"

namespace mrpt_mapconv::terrain
{
/** Grows new planes from cells without one. */
class PlaneGrowth
{
 public:
  PlaneGrowth(const PlaneSearch& search, TileMap& tiles)
      : m_search(search), m_seedPlane(search), m_flood(tiles)
  {
  }

  /** Tries all seeds that have no plane, in the order of their keys, row by row.
   * \param seeds of tiles row by row \param threads 0 = all cores */
  void grow(const std::vector<TileCells>& seeds, PlaneSet& planes, int threads);

 private:
  bool growFrom(const CellRef& seed, PlaneSet& planes);
  bool flood(const CellRef& seed, const Plane& plane);

  PlaneSearch m_search;
  SeedPlane m_seedPlane;
  Flood m_flood;
};

}  // namespace mrpt_mapconv::terrain
