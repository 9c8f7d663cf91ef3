#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/sim/World.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mrpt_mapconv::eval
{
/** Which cells are judged: those that are not 0. */
using CellMask = grid::Layer<std::uint8_t>;

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

/** Map minus truth in the judged cells that are finite in both layers, row by row. */
std::vector<double> errorsOf(const grid::Layer<float>& map, const grid::Layer<float>& truth,
                             const CellMask& judged);

/** A root mean square error and the number of cells that it is of. */
struct Rmse
{
  double value = 0;  //!< in the layers' unit; NaN for no cells
  std::size_t cells = 0;
};

/** Of errorsOf(). */
Rmse rmse(const grid::Layer<float>& map, const grid::Layer<float>& truth, const CellMask& judged);

/** The cells at whose centre a body stands whose name (without its kind) begins like one of
 * `names`. */
CellMask cellsOf(const sim::World& world, const std::vector<std::string>& names,
                 const grid::GridFrame& frame);

/** How many cells of a map are labelled as they are in truth, as table I of Mora et al. (IEEE
 * Sensors Journal 2024) counts them. */
struct LabelScore
{
  std::size_t correct = 0;   //!< of the labelled cells, those with the true label
  std::size_t labelled = 0;  //!< cells that the map has as free or occupied, wherever they are
  std::size_t found = 0;     //!< of the cells that should be labelled, those with the true label
  std::size_t should = 0;    //!< cells that should be labelled

  double precision() const;  //!< correct of those labelled, [0, 1]; NaN if the map labels nothing
  double recall() const;     //!< found of those that should be, [0, 1]; NaN if there are none
  double fScore() const;     //!< harmonic mean of both; NaN if one is NaN or both are 0
};

/** The cells that a map of all that can be seen would label: the free ones that 4-connected free
 * cells join to the one at (x, y) [m], and the occupied ones among the 8 around each of them.
 * \exception std::invalid_argument naming the place if its cell is not free in truth */
CellMask cellsToLabel(const grid::Layer<float>& truth, double x, double y);

/** Compares the labels of a map with those of the truth. A cell that one of them does not have is
 * unknown there: what the map labels where the truth is unknown or ends is wrong.
 *
 * \param map,truth,should of the same resolution; each may have a frame of its own
 * \exception std::invalid_argument for different resolutions */
LabelScore scoreLabels(const grid::Layer<float>& map, const grid::Layer<float>& truth,
                       const CellMask& should);

/** Number of the masked cells that are occupied in truth and free on the map: a robot would drive
 * into them. \exception std::invalid_argument for different resolutions */
std::size_t occupiedLabelledFree(const grid::Layer<float>& map, const grid::Layer<float>& truth,
                                 const CellMask& mask);

/** The cells that both masks have, on the frame of `a`. */
CellMask both(const CellMask& a, const CellMask& b);

/** The cells of a layer with a value of at least `least`. */
CellMask cellsFrom(const grid::Layer<float>& layer, float least);

}  // namespace mrpt_mapconv::eval
