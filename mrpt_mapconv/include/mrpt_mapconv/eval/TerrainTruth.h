#pragma once

#include <mrpt_mapconv/eval/CellMask.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/sim/World.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cstdint>
#include <vector>

namespace mrpt_mapconv::eval
{
/** The true surface, at the centre of each cell of a frame. */
struct TerrainTruth
{
  grid::Layer<float> height;  //!< top of the lowest solid [m]; NaN: none, or beyond the bounds
  /** Cells that have no single height, and those around them: a jump goes through them, or there
   * are further surfaces above the lowest. */
  CellMask apart;
  grid::Layer<std::int32_t> plane;            //!< index in `planes`; −1: none
  std::vector<terrain::TerrainPlane> planes;  //!< by their first cells, row by row
};

/** Evaluates a world.
 *
 * A jump is one of the lowest solid's top, as sim::truthLayers() looks for it. Cells of a plane are
 * connected through common sides, have the same slope, and heights within 1e-6 m of the plane; at
 * least three of them, in two rows and two columns, tell how it is tilted. Where there are several
 * surfaces there is no plane.
 *
 * \param jump least height of a jump that sets cells apart [m]
 * \param threads 0 = all cores
 * \exception std::invalid_argument unless jump is finite and at least 0 m */
TerrainTruth terrainTruth(const sim::World& world, const grid::GridFrame& frame, double jump,
                          int threads = 0);

}  // namespace mrpt_mapconv::eval
