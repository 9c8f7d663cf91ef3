#pragma once

#include <mrpt_mapconv/grid/Layer.h>

#include <string>

#include "output/Json.h"

namespace mapconv
{
/** How long the stages of a command took [s]. */
struct Seconds
{
  double load = 0, convert = 0, write = 0;
  std::string work = "convert";  //!< what the stage between loading and writing is called
};

/** How many cells of an occupancy layer are what. */
struct OccupancyCounts
{
  std::size_t free = 0, occupied = 0, unknown = 0;
};

OccupancyCounts countsOf(const mrpt_mapconv::grid::Layer<float>& occupancy);

/** What was read and where the results are. */
struct Job
{
  std::string input, inputKind, outputDir;
};

/** The first lines of a summary: what was made of what, and how large it is. */
std::string headText(const Job& job, const mrpt_mapconv::grid::GridFrame& frame);
/** The line with the counts, in cells and as shares of all cells. `label` is up to 11 characters.
 */
std::string countsText(const std::string& label, const OccupancyCounts& counts);
std::string secondsText(const Seconds& seconds);

/** The JSON object with what every summary has. */
JsonObject summaryJson(const Job& job, const mrpt_mapconv::grid::GridFrame& frame,
                       const OccupancyCounts& counts);
JsonObject secondsJson(const Seconds& seconds);

}  // namespace mapconv
