#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "experiment/freespace/FreespaceMaps.h"
#include "experiment/freespace/GroundPaths.h"
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
  GroundRuns groundRuns;
};

using Results = std::vector<std::reference_wrapper<const FreespaceResult>>;

/** Each adds a part of the report, of the paper's worlds. @{ */
/** Table II: full conversions and updates against fixed projection, with box plots (figure 2) and
 * the cost against the number of changed columns. */
void addSpeed(const Results& results, Report& report);

/** Table III: sizes of the 2D maps in per cent of the octree's. */
void addSizes(const Results& results, Report& report);

/** What the paper shows in pictures, as numbers: precision and recall of free and occupied cells,
 * errors of heights and slopes, low walls and objects, share of the free area. */
void addQuality(const Results& results, Report& report);

/** Random start–goal pairs: paths found, and whether they touch the true world. */
void addPaths(const Results& results, const FreespaceSettings& settings, Progress& progress,
              Report& report);
/** @} */

/** Each adds a part of the report about ground that was seen, of all worlds. @{ */
/** The ground maps, with floors of the lowest free range and of what was seen: cells, paths, and
 * whether the latter is better where it has to be. */
void addGround(const Results& results, Report& report);

/** Edges of drops on these maps, of worlds with FreespaceWorld::drops. */
void addDrops(const Results& results, Report& report);
/** @} */

}  // namespace mapconv
