#pragma once

#include <memory>
#include <vector>

#include "experiment/freespace/FreespaceMaps.h"
#include "experiment/report/Report.h"

namespace mapconv
{
/** A world of the experiment with all that was made of it. */
struct FreespaceResult
{
  FreespaceWorld world;
  std::shared_ptr<const mrpt_mapconv::sim::Scenario> scenario;
  Exploration run;
  FreespaceMaps maps;
};

/** Each adds a part of the report. @{ */
/** Table II: full conversions and updates against fixed projection, with box plots (figure 2) and
 * the cost against the number of changed columns. */
void addSpeed(const std::vector<FreespaceResult>& results, Report& report);

/** Each adds a part of the report. @{ */
/** Table III: sizes of the 2D maps in per cent of the octree's. */
void addSizes(const std::vector<FreespaceResult>& results, Report& report);

/** What the paper shows in pictures, as numbers: precision and recall of free and occupied cells,
 * errors of heights and slopes, low walls and objects, share of the free area. */
void addQuality(const std::vector<FreespaceResult>& results, Report& report);

/** Random start–goal pairs: paths found, and whether they touch the true world. */
void addPaths(const std::vector<FreespaceResult>& results, const FreespaceSettings& settings,
              Progress& progress, Report& report);
/** @} */

}  // namespace mapconv
