#pragma once

#include <mrpt_mapconv/eval/OccupancyScore.h>

#include "experiment/freespace/FreespaceResult.h"

namespace mapconv
{
/** What a ground robot's map says right and wrong, in cells in view but for the frontier. */
struct GroundFigures
{
  mrpt_mapconv::eval::OccupancyScore score;
  /** Truly free cells labelled occupied that are farther than slopeWindow cells from every cell
   * that is not truly free. Of all of them see `score.occupied.wrong`. */
  std::size_t falseAwayFromAll = 0;
  std::size_t occupiedLabelledFree = 0;
  std::size_t frontier = 0;           //!< cells whose ground nobody saw, of the whole map
  std::size_t frontierTrulyFree = 0;  //!< those among them that are free
  double lowWalls = 0, objects = 0;   //!< share of such bodies' cells found within one cell

  std::size_t trulyOccupied() const { return score.occupied.found + score.occupied.missed; }
};

GroundFigures groundFigures(const FreespaceResult& result, const GroundMap& map);

}  // namespace mapconv
