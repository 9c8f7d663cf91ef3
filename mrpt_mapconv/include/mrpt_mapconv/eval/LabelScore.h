#pragma once

#include <mrpt_mapconv/eval/CellMask.h>

#include <cstddef>

namespace mrpt_mapconv::eval
{
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

}  // namespace mrpt_mapconv::eval
