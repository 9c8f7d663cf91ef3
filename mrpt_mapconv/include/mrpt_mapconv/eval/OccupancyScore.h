#pragma once

#include <mrpt_mapconv/eval/CellMask.h>

#include <cstddef>

namespace mrpt_mapconv::eval
{
/** How well a map tells where something is. Cell by cell, `right` and `found` are the same. */
struct Agreement
{
  std::size_t right = 0;   //!< the map says so, and it is true
  std::size_t wrong = 0;   //!< the map says so, and it is not true
  std::size_t found = 0;   //!< it is true, and the map says so
  std::size_t missed = 0;  //!< it is true, and the map does not say so

  double precision() const;  //!< right of what the map says, [0, 1]; NaN if it says nothing
  double recall() const;     //!< found of what is true, [0, 1]; NaN if there is none
};

struct OccupancyScore
{
  Agreement free, occupied;
};

/** Compares an occupancy map with the truth, cell by cell, where `judged` says so and the truth is
 * not unknown. A cell outside the map is unknown there.
 *
 * \param map,truth,judged of the same resolution; each may have a frame of its own
 * \exception std::invalid_argument for different resolutions */
OccupancyScore scoreOccupancy(const grid::Layer<float>& map, const grid::Layer<float>& truth,
                              const CellMask& judged);

/** The same, but within one cell, and both ways: a label of the map is right if some cell of the
 * 3 × 3 around has it in the truth, and wrong otherwise; a true label is found if some cell of the
 * 3 × 3 around has it in the map, and missed otherwise. So `right`, which counts the map's cells,
 * and `found`, which counts the truth's, may differ. The cell in the middle has to be a judged one
 * where the truth is known; those around it need not. */
OccupancyScore scoreWithinOneCell(const grid::Layer<float>& map, const grid::Layer<float>& truth,
                                  const CellMask& judged);

/** Share of the judged cells with a true label that the map has exactly right. [0, 1]; NaN if there
 * is no such cell. */
double shareRight(const grid::Layer<float>& map, const grid::Layer<float>& truth,
                  const CellMask& judged);

/** Share of the judged cells with a true label that the map has right within one cell: some cell of
 * the 3 × 3 around has that label. [0, 1]; NaN if there is no such cell. Wrong labels do not count:
 * a checkerboard has 1. See scoreWithinOneCell(). */
double shareRightWithinOneCell(const grid::Layer<float>& map, const grid::Layer<float>& truth,
                               const CellMask& judged);

}  // namespace mrpt_mapconv::eval
