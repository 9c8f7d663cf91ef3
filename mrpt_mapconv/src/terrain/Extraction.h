#pragma once

#include <vector>

#include "PlaneBorders.h"

namespace mrpt_mapconv::terrain
{
/** Cells without a plane, of tiles row by row. */
struct OpenCells
{
  std::vector<TileCells> all;    //!< that might join a plane
  std::vector<TileCells> seeds;  //!< from which new ones are looked for
  bool areAllCells = false;      //!< of the map
};

/** Has planes follow the cells that have changed. */
class Extraction
{
 public:
  Extraction(const PlaneSearch& search, TileMap& tiles, PlaneSet& planes)
      : m_search(search),
        m_tiles(tiles),
        m_planes(planes),
        m_growth(search, tiles),
        m_borders(search, tiles, planes)
  {
  }

  /** \param threads 0 = all cores */
  void follow(OpenCells open, int threads);

 private:
  void refit() { m_planes.refit(m_search.minCells); }
  void settleBorders(int threads);

  const PlaneSearch& m_search;
  TileMap& m_tiles;
  PlaneSet& m_planes;
  PlaneGrowth m_growth;
  PlaneBorders m_borders;
};

}  // namespace mrpt_mapconv::terrain
